// Grey levels between the pixels of a picture, for many places side by side.
#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace alltact {

/// Cubic convolution (Keys 1981, a = -1/2): of the third order, so that even slopes are neither
/// shifted nor bent. Beyond the picture its outermost pixels continue.
class CubicPicture {
 public:
  explicit CubicPicture(const cv::Mat& grey);  ///< CV_8UC1, not empty

  /// out[i] = the grey level at (u[i], v[i]) px, for `count` places rounded to 1/2048 px; off by
  /// 0.2 levels at most before it is rounded. Quick where places lie about a pixel apart.
  void look_up(const float* u, const float* v, int count, std::uint8_t* out) const;

 private:
  cv::Size size_;
  cv::Mat bordered_;
};

}  // namespace alltact
