#include "core/sensing/reference/hidden_ends.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kBorder = 12;  // columns: a face that ends there may continue outside
constexpr std::size_t kMinShowing = 8;
constexpr double kMinMm = 0.5, kScatters = 6.0;
constexpr double kFurthest = 0.4;  // of the face's length, by which it is extended

bool is_end(int u, int width_px) {
  return u >= kBorder && u < width_px - kBorder;
}

}  // namespace

EndLengths::EndLengths(const std::vector<FaceChart>& charts, int width_px) {
  std::vector<double> first, last;
  for (const FaceChart& chart : charts) {
    if (is_end(chart.first, width_px)) first.push_back(chart.along_mm.front());
    if (is_end(chart.end() - 1, width_px)) last.push_back(chart.along_mm.back());
  }
  first_ = end_of(std::move(first), charts.size());
  last_ = end_of(std::move(last), charts.size());
}

std::optional<EndLengths::End> EndLengths::end_of(std::vector<double> lengths_mm,
                                                  std::size_t frames) {
  if (lengths_mm.size() < kMinShowing || 2 * lengths_mm.size() < frames) return std::nullopt;
  const double middle = upper_median(lengths_mm);
  for (double& length : lengths_mm) length = std::abs(length - middle);
  constexpr double kSdOfMedian = 1.4826;  // sd over median deviation of a normal distribution
  const double sd = kSdOfMedian * upper_median(lengths_mm);
  return End{middle, std::max(kMinMm, kScatters * sd)};
}

std::vector<HiddenColumn> EndLengths::hidden_columns(const FaceChart& now, int width_px) const {
  const bool before =
      first_ && now.first > kBorder && now.along_mm.front() > first_->mm + first_->tolerance_mm;
  const bool after = last_ && now.end() < width_px - kBorder &&
                     now.along_mm.back() < last_->mm - last_->tolerance_mm;
  std::vector<HiddenColumn> columns;
  if (!before && !after) return columns;
  const FaceChart extended = widened(now, kFurthest);
  for (int u = std::max(0, extended.first); u < std::min(width_px, extended.end()); ++u) {
    const auto i = static_cast<std::size_t>(u - extended.first);
    const double s_mm = extended.along_mm[i];
    if ((before && u < now.first && s_mm >= first_->mm) ||
        (after && u >= now.end() && s_mm <= last_->mm))
      columns.push_back({u, extended.upper_v[i], extended.lower_v[i]});
  }
  return columns;
}

}  // namespace alltact
