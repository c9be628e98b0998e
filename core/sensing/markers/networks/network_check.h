// Check that a network computes the same on this computer as where it was trained.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Content of NAME.yaml next to NAME.onnx:
///   size [width, height]       of the image of check_image(), px; key: see NetworkCheck::load
///   every: 13                  stride between the listed numbers of the output
///   tolerance: 0.001
///   output: [ ... ]            the first number, the one `every` further, and so on
struct NetworkCheck {
  cv::Size image_size;
  int every = 1;
  double tolerance = 0;
  std::vector<double> output;

  /// nullopt: the file does not exist. Error: it cannot be read, or has a line of another form.
  static Result<std::optional<NetworkCheck>> load(const std::filesystem::path& yaml);

  /// Error: another count of numbers, or one that is off by more than the tolerance.
  [[nodiscard]] Status holds(const cv::Mat& got, const std::filesystem::path& onnx) const;
};

/// Synthetic image: ramps and discs of four sizes, bright and dark, the same as in
/// train_marker_network.py.
[[nodiscard]] cv::Mat check_image(const cv::Size& size);

}  // namespace alltact
