#include "core/numerics/image_noise.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace alltact {
namespace {

constexpr int kLargest = 64;  // of the second differences that count

/// Second differences along a row, without its ends; kLargest + 1 where they do not count.
ALLTACT_WIDE void second_differences(const std::uint8_t* __restrict pixels, int count,
                                     std::uint8_t* __restrict differences) {
  constexpr int kFloor = 6, kCeiling = 250;
  for (int i = 0; i < count; ++i) {
    const int here = pixels[i + 1];
    const int second = pixels[i] - 2 * here + pixels[i + 2];
    const int size = second < 0 ? -second : second;
    const bool counts = (here >= kFloor) & (here <= kCeiling) & (size <= kLargest);
    differences[i] = static_cast<std::uint8_t>(counts ? size : kLargest + 1);
  }
}

/// Histogram of the values. Several copies of the counts: neighbours are often equal, and each
/// increment would wait for the previous write.
class Histogram {
 public:
  void add(const std::vector<std::uint8_t>& values) {
    std::size_t i = 0;
    for (; i + kCopies <= values.size(); i += kCopies)
      for (std::size_t copy = 0; copy < kCopies; ++copy) ++counts_[copy][values[i + copy]];
    for (; i < values.size(); ++i) ++counts_[0][values[i]];
  }
  [[nodiscard]] std::array<std::int64_t, kLargest + 1> counts() const {
    std::array<std::int64_t, kLargest + 1> all{};
    for (const auto& counts : counts_)
      for (std::size_t k = 0; k < all.size(); ++k) all[k] += counts[k];
    return all;
  }

 private:
  static constexpr std::size_t kCopies = 4;
  std::array<std::array<std::int32_t, kLargest + 2>, kCopies> counts_{};
};

}  // namespace

double image_noise_sd(const cv::Mat& grey) {
  CV_Assert(grey.type() == CV_8UC1);
  constexpr int kRows = 32;  // enough rows
  const double quantisation = std::sqrt(1.0 / 12.0);

  if (grey.cols < 3) return quantisation;
  Histogram histogram;
  std::vector<std::uint8_t> differences(static_cast<std::size_t>(grey.cols - 2));
  const int step = std::max(1, grey.rows / kRows);
  for (int row = step / 2; row < grey.rows; row += step) {
    second_differences(grey.ptr<std::uint8_t>(row), grey.cols - 2, differences.data());
    histogram.add(differences);
  }
  const auto sd = sd_of_differences(histogram.counts());
  if (!sd) return quantisation;
  return std::max(*sd / std::sqrt(6.0),
                  quantisation);  // 1 + 4 + 1: variance of a second difference
}

std::optional<double> sd_of_differences(std::span<const std::int64_t> histogram) {
  // Clips at 3 sd and corrects for the clipping until it converges.
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
