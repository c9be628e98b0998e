// The groups that make up hard_rows(), a file each, and their common functions.
#pragma once

#include "calibration/hard_cases/hard_cases.h"
#include "core/result.h"
#include "core/sensing/face/face_shape.h"

namespace alltact {

[[nodiscard]] std::vector<HardRow> hard_directions();  ///< angles, rays, slopes: in 50 digits
[[nodiscard]] std::vector<HardRow> hard_outlines();    ///< balls and circles from their borders
[[nodiscard]] std::vector<HardRow> hard_faces();       ///< distance from width, edges
[[nodiscard]] std::vector<HardRow> hard_curves();      ///< least squares, mappings
[[nodiscard]] std::vector<HardRow> hard_lenses();      ///< distortion and its inverse
[[nodiscard]] std::vector<HardRow> hard_brightness();  ///< differences, references
[[nodiscard]] std::vector<HardRow> hard_contacts();    ///< angle, direction, markers

/// A rigid flat sensor under a telecentric lens; the face fills the image.
[[nodiscard]] FaceShape flat_sensor(const cv::Size& size, double mm_per_px);

[[nodiscard]] inline HardAnswer number(double value) {
  return {{value}, ""};
}
[[nodiscard]] inline HardAnswer refused(std::string why) {
  return {{}, std::move(why)};
}
/// Answer of a step that gives no reasons: a number, or `why` where there is none.
[[nodiscard]] inline HardAnswer number_or(const std::optional<double>& value, std::string why) {
  return value ? number(*value) : refused(std::move(why));
}

/// A question with a number for an answer; `scale` is the unit of errors.
[[nodiscard]] inline HardQuestion expected(double truth, double scale) {
  return {{truth}, {}, scale};
}
/// The same; errors are relative to the truth.
[[nodiscard]] inline HardQuestion expected(double truth) {
  return expected(truth, std::abs(truth));
}
/// A question without an answer; the refusal must contain one of `reasons`.
[[nodiscard]] inline HardQuestion expected_refusal(std::vector<std::string> reasons) {
  return {{}, std::move(reasons), 1};
}

}  // namespace alltact
