// From a picture to what a network takes, and from what it gives to dots.
#pragma once

#include "core/sensing/markers/networks/dot_network.h"

#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// How a picture lies in another: u = (x - left) / scale with pixel middles at whole numbers.
struct Laid {
  double scale = 1, left = 0, top = 0;
  [[nodiscard]] double u(double x) const { return (x - left) / scale; }
  [[nodiscard]] double v(double y) const { return (y - top) / scale; }
};

/// The picture in whole blocks of so many pixels that it is about 960 px wide, and the square root
/// of grey / 255 as [1, 1, height, width]; the network for dots takes that.
[[nodiscard]] cv::Mat dots_input(const cv::Mat& grey, Laid* laid);

/// The picture in the middle of `size`, as large as fits, the rest grey (114): [1, channels,
/// height, width], grey / 255 in each.
[[nodiscard]] cv::Mat boxes_input(const cv::Mat& grey,
                                  const cv::Size& size,
                                  int channels,
                                  Laid* laid);

/// Peaks of the first channel of [1, 3, h, w], surest first; of two whose extents overlap the
/// surer.
[[nodiscard]] std::vector<SeenDot> dots_of(const cv::Mat& output, const Laid& laid);

/// Boxes of [1, 4 + classes, N] or [1, N, 4 + classes], the surer of any two that share half of
/// what they cover together.
[[nodiscard]] std::vector<SeenDot> boxes_of(const cv::Mat& output, const Laid& laid);

}  // namespace alltact
