// The exact answer that goes with a simulated picture.
#pragma once

#include "core/simulation/contact_truth.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// What of a frame's truth is asked for.
enum class TruthDetail {
  kAll,
  kWithoutPictures,  ///< its pictures stay empty: costs next to nothing
};

/// From the same analytic geometry as the picture, never from its pixels. Camera frame, mm, px.
struct Truth {
  cv::Mat depth_mm;  ///< CV_32FC1, the picture's size, along z; NaN off the face
  cv::Mat
      untouched_z_mm;  ///< CV_32FC1, z of the locally undeformed face above the pixel's view point
  cv::Mat view_z_mm;   ///< CV_32FC1, z of the view face; NaN off the face
  struct Dot {
    double u, v;
    bool visible;
  };
  /// Centres of the dots' images, by number; empty unless the scene names markers.
  std::vector<Dot> markers;
  /// depth_mm: greatest press depth along z.
  struct Ball {
    Eigen::Vector3d centre_mm;
    double radius_mm;
    double depth_mm;
  };
  std::optional<Ball> ball;            ///< the first that the scene names
  std::vector<Ball> balls;             ///< all that press in this frame, in the scene's order
  std::vector<ContactTruth> contacts;  ///< whatever presses on the finger, in the scene's order
  std::map<std::string, double> pose;  ///< what moved the finger, by name: q1_mm, ...
  /// Everything but the pictures, as one JSON object (a frame's entry in truth.json).
  [[nodiscard]] std::string to_json() const;
};

/// What a pixel's middle sees.
enum class Seen : std::uint8_t { kNothing = 0, kFace, kSide, kDot, kFoldOverDot };

/// The exact answer for every pixel, the picture's size, from the same geometry and light as the
/// picture, at the frame's own moment.
struct TruthMaps {
  cv::Mat contact;  ///< CV_8UC1: what touches there, 1 + its number in Truth::contacts; 0: nothing
  /// CV_32FC3: unit normal of the outer side as it lies now, away from the camera, camera frame;
  /// NaN off the face.
  cv::Mat normal;
  /// CV_32FC1, grey levels: the light that would come to the sensor if nothing pressed into the
  /// face, the finger's pose and the lamps being the same.
  cv::Mat untouched_grey;
  cv::Mat seen;  ///< CV_8UC1, Seen
};

}  // namespace alltact
