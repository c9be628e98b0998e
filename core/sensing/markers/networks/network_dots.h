// Converts images to network inputs, and network outputs to dots.
#pragma once

#include "core/sensing/markers/networks/dot_network.h"

#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Map from the input of a network to the image: u = (x - left) / scale, with pixel centres at
/// integers.
struct InputMap {
  double scale = 1, left = 0, top = 0;
  [[nodiscard]] double u(double x) const { return (x - left) / scale; }
  [[nodiscard]] double v(double y) const { return (y - top) / scale; }
};

/// Input of the network for dots: the image reduced by an integer factor to a width of about 960
/// px, and the square root of grey / 255 as [1, 1, height, width].
[[nodiscard]] cv::Mat dots_input(const cv::Mat& grey, InputMap* input_map);

/// Letterboxed input of a network for boxes: the image as large as fits in the middle of `size`,
/// the rest grey (114). [1, channels, height, width], grey / 255 in each.
[[nodiscard]] cv::Mat boxes_input(const cv::Mat& grey,
                                  const cv::Size& size,
                                  int channels,
                                  InputMap* input_map);

/// Peaks of the first channel of [1, 3, h, w], highest score first; of two with overlapping extents
/// the one of higher score.
[[nodiscard]] std::vector<NetworkDot> dots_of(const cv::Mat& output, const InputMap& input_map);

/// Boxes of [1, 4 + classes, N] or [1, N, 4 + classes], by non-maximum suppression at an
/// intersection over union of 0.45.
[[nodiscard]] std::vector<NetworkDot> boxes_of(const cv::Mat& output, const InputMap& input_map);

}  // namespace alltact
