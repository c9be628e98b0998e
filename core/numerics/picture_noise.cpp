#include "core/numerics/picture_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace alltact {

double picture_noise_sd(const cv::Mat& grey) {
  CV_Assert(grey.type() == CV_8UC1);
  constexpr int kRows = 32;  // are enough
  constexpr int kLargest = 64;
  constexpr int kFloor = 6, kCeiling = 250;
  const double quantisation = std::sqrt(1.0 / 12.0);

  std::array<std::int64_t, kLargest + 1> histogram{};
  const int step = std::max(1, grey.rows / kRows);
  for (int row = step / 2; row < grey.rows; row += step) {
    const auto* pixel = grey.ptr<std::uint8_t>(row);
    for (int u = 1; u + 1 < grey.cols; ++u) {
      if (pixel[u] < kFloor || pixel[u] > kCeiling) continue;
      const int second = std::abs(pixel[u - 1] - 2 * pixel[u] + pixel[u + 1]);
      if (second <= kLargest) ++histogram[static_cast<std::size_t>(second)];
    }
  }
  const auto sd = sd_of_differences(histogram);
  if (!sd) return quantisation;
  return std::max(*sd / std::sqrt(6.0),
                  quantisation);  // 1 + 4 + 1: variance of a second difference
}

std::optional<double> sd_of_differences(std::span<const std::int64_t> histogram) {
  // Clip at 3 sd and correct for the clipping until nothing changes.
  constexpr double kClipSd = 3.0;
  constexpr double kClippedVariance = 0.9733;  // of a normal distribution cut at 3 sd
  const int largest = static_cast<int>(histogram.size()) - 1;
  double sd = largest / kClipSd;
  for (int round = 0; round < 20; ++round) {
    double sum = 0;
    std::int64_t count = 0;
    const int limit = std::min(largest, static_cast<int>(std::ceil(kClipSd * sd)));
    for (int k = 0; k <= limit; ++k) {
      sum +=
          static_cast<double>(k) * k * static_cast<double>(histogram[static_cast<std::size_t>(k)]);
      count += histogram[static_cast<std::size_t>(k)];
    }
    if (count < 100) return std::nullopt;
    const double next =
        std::max(std::sqrt(sum / static_cast<double>(count) / kClippedVariance), 0.5);
    if (std::abs(next - sd) < 1e-3) break;
    sd = next;
  }
  return sd;
}

}  // namespace alltact
