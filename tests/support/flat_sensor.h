// A rigid sensor seen straight on, with balls pressed into it, from closed formulas: quick, and
// independent of the program's own simulation.
#pragma once

#include "core/finger/finger.h"

#include <cstdint>
#include <filesystem>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact::test {

struct FlatSensor {
  static constexpr int kWidth = 320, kHeight = 240;
  static constexpr double kMmPerPx = 0.06;
  static constexpr double kLayerMm = 3.0;
  static constexpr double kBallRadiusMm = 4.0;
  /// True mapping: d = kA x / (1 + kB x).
  static constexpr double kA = 2.2, kB = 1.5;
};

/// The sensor as its finger.yaml describes it, with the true mapping where it is calibrated.
Finger flat_sensor_finger(bool is_calibrated);

/// Depth in mm of a ball pressed `depth_mm` deep at a pixel; 0 outside the contact.
cv::Mat_<float> ball_depth_mm(double u, double v, double depth_mm);

/// The untouched picture: brightest in the middle, noise of 0.7 grey levels.
cv::Mat untouched_picture(std::uint64_t seed);

/// The same with the face pressed in, noise drawn anew.
cv::Mat pressed_picture(const cv::Mat_<float>& depth_mm, std::uint64_t seed);

/// camera.yaml of the sensor.
void write_flat_camera(const std::filesystem::path& file);

/// Writes camera.yaml, ref.png and four presses (press_0.png ...) of different depth and place.
/// Returns the presses' files.
std::vector<std::filesystem::path> write_flat_sensor(const std::filesystem::path& folder);

}  // namespace alltact::test
