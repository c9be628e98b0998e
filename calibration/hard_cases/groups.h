// The groups that hard_cases() is made of, a file each.
#pragma once

#include "calibration/hard_cases/hard_cases.h"
#include "core/sensing/face_shape.h"

#include <cmath>
#include <limits>

namespace alltact {

[[nodiscard]] std::vector<HardCase> hard_directions();  ///< angles, rays, slopes: in 50 digits
[[nodiscard]] std::vector<HardCase> hard_outlines();    ///< balls and circles from their borders
[[nodiscard]] std::vector<HardCase> hard_faces();       ///< distance from width, edges
[[nodiscard]] std::vector<HardCase> hard_curves();      ///< least squares, mappings
[[nodiscard]] std::vector<HardCase> hard_lenses();      ///< distortion and its inverse
[[nodiscard]] std::vector<HardCase> hard_brightness();  ///< differences, references
[[nodiscard]] std::vector<HardCase> hard_contacts();    ///< angle, direction, markers

/// A rigid flat sensor under a telecentric lens; the whole picture is face.
[[nodiscard]] FaceShape flat_sensor(const cv::Size& size, double mm_per_px);

/// |value - truth| / |truth|.
[[nodiscard]] inline double relative_error(double value, double truth) {
  return std::abs((value - truth) / truth);
}

/// The greater of an error and what was found before; infinite where the error is no number.
inline void keep_worst(double error, double& worst) {
  worst = std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(worst, error);
}

}  // namespace alltact
