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

/// The same in single precision and without branches, for hot loops: the nearest pixel beyond the
/// border. The compiler vectorises loads from fixed pointers only. `image`: CV_32FC1, at least 2 x
/// 2; it must outlive this.
class BilinearSamples {
 public:
  explicit BilinearSamples(const cv::Mat& image)
      : here_(image.ptr<float>()),
        right_(here_ + 1),
        below_(here_ + image.step1()),
        diagonal_(below_ + 1),
        step_(static_cast<int>(image.step1())),
        last_u_(static_cast<float>(image.cols) - kInside),
        last_v_(static_cast<float>(image.rows) - kInside) {}

  [[nodiscard, gnu::always_inline]] float at(float u, float v) const {
    const float x = std::min(std::max(u, 0.0F), last_u_);
    const float y = std::min(std::max(v, 0.0F), last_v_);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const float a = x - static_cast<float>(i), b = y - static_cast<float>(j);
    const int k = j * step_ + i;
    const float above = here_[k] + a * (right_[k] - here_[k]);
    return above + b * (below_[k] + a * (diagonal_[k] - below_[k]) - above);
  }

 private:
  static constexpr float kInside = 1.001F;
  const float *here_, *right_, *below_, *diagonal_;
  int step_;
  float last_u_, last_v_;
};

/// A single one.
[[nodiscard]] inline float bilinear_within(const cv::Mat& image, float u, float v) {
  return BilinearSamples(image).at(u, v);
}

}  // namespace alltact
