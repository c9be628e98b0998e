// Interpolation in a float image.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Bilinear value of a CV_32FC1 image at a pixel position; NaN when any of the four pixels around
/// it is NaN or lies outside.
[[nodiscard]] inline double bilinear(const cv::Mat& image, const Eigen::Vector2d& pixel) {
  const auto u = static_cast<int>(std::floor(pixel.x()));
  const auto v = static_cast<int>(std::floor(pixel.y()));
  if (u < 0 || v < 0 || u + 1 >= image.cols || v + 1 >= image.rows)
    return std::numeric_limits<double>::quiet_NaN();
  const double a = pixel.x() - u, b = pixel.y() - v;
  const float* top = image.ptr<float>(v) + u;
  const float* bottom = image.ptr<float>(v + 1) + u;
  return (1 - b) * ((1 - a) * static_cast<double>(top[0]) + a * static_cast<double>(top[1])) +
         b * ((1 - a) * static_cast<double>(bottom[0]) + a * static_cast<double>(bottom[1]));
}

}  // namespace alltact
