// Which pixels of an image of measurements have a value.
#pragma once

#include <limits>

#include <opencv2/core.hpp>

namespace alltact {

/// 255 where `x` is finite, 0 where it is NaN or infinite: both mean that nothing was measured. x:
/// CV_32FC1; returns CV_8UC1 of its size.
[[nodiscard]] inline cv::Mat measured_pixels(const cv::Mat& x) {
  return cv::abs(x) < std::numeric_limits<float>::infinity();  // false for NaN
}

}  // namespace alltact
