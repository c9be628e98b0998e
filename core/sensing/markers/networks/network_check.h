// Whether a network computes on this computer what it computed where it was made.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// What stands in NAME.yaml beside NAME.onnx:
///   picture: [width, height]   of check_picture, px
///   every: 13                  so many numbers of the output lie between those below
///   tolerance: 0.001
///   output: [ ... ]            the first of it, the one `every` further, and so on
struct NetworkCheck {
  cv::Size picture;
  int every = 1;
  double tolerance = 0;
  std::vector<double> output;

  /// nullopt: there is no such file. Error: it cannot be read, or a line of it is not as above.
  static Result<std::optional<NetworkCheck>> load(const std::filesystem::path& yaml);

  /// Error: another count of numbers, or one that is further off than the tolerance.
  [[nodiscard]] Status holds(const cv::Mat& got, const std::filesystem::path& onnx) const;
};

/// Ramps and discs of four sizes, bright and dark, the same in train_marker_network.py.
[[nodiscard]] cv::Mat check_picture(const cv::Size& size);

}  // namespace alltact
