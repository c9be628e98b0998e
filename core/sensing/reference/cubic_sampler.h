// Interpolated grey levels of an image at many adjacent positions.
#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

namespace alltact {

/// Cubic convolution (Keys 1981, a = -1/2) of third order: even slopes are neither shifted nor
/// bent. Outside of the image its outermost pixels continue.
class CubicSampler {
 public:
  explicit CubicSampler(const cv::Mat& grey);  ///< CV_8UC1, not empty

  /// out[i] = the grey level at (u[i], v[i]) px, for `count` positions rounded to 1/2048 px. The
  /// error is at most 0.2 levels before rounding. Fast where positions lie about a pixel apart.
  void sample(const float* u, const float* v, int count, std::uint8_t* out) const;

 private:
  cv::Size size_;
  cv::Mat bordered_;
};

}  // namespace alltact
