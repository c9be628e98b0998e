// Noise of an image, estimated from the image itself.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviation of the noise of a CV_8UC1 image in grey levels, from second differences along
/// every 16th row, which suppress smooth content. Differences beyond 3 sd (dots, edges) do not
/// count, nor do pixels at the floor or the ceiling. At least that of quantisation (1/sqrt(12)),
/// which is also returned when too few pixels qualify.
[[nodiscard]] double image_noise_sd(const cv::Mat& grey);

/// Standard deviation, grey levels, of normal differences with outliers: from those within 3 sd,
/// corrected for the cut. `histogram`: counts of the magnitudes 0, 1, 2, ... grey levels. At least
/// 0.5; nullopt: fewer than 100 within 3 sd.
[[nodiscard]] std::optional<double> sd_of_differences(std::span<const std::int64_t> histogram);

// Interpolation in a float image.

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

/// In single precision and without branches, for hot loops: the nearest pixel beyond the border.
/// `image`: CV_32FC1, at least 2 x 2.
[[nodiscard]] inline float bilinear_within(const cv::Mat& image, float u, float v) {
  constexpr float kInside = 1.001F;
  const float x = std::min(std::max(u, 0.0F), static_cast<float>(image.cols) - kInside);
  const float y = std::min(std::max(v, 0.0F), static_cast<float>(image.rows) - kInside);
  const int i = static_cast<int>(x), j = static_cast<int>(y);
  const float a = x - static_cast<float>(i), b = y - static_cast<float>(j);
  const float* top = image.ptr<float>(j) + i;
  const float* bottom = image.ptr<float>(j + 1) + i;
  const float above = top[0] + a * (top[1] - top[0]);
  return above + b * (bottom[0] + a * (bottom[1] - bottom[0]) - above);
}

}  // namespace alltact
