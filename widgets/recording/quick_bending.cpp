#include "widgets/recording/quick_bending.h"

#include "core/live/source_runner.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace alltact {
namespace {

/// Of the markers seen in both frames; nullopt: none.
std::optional<double> median_displacement_px(const Markers& a, const Markers& b) {
  std::vector<double> displacements_px;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (a[i].seen && b[i].seen)
      displacements_px.push_back(std::hypot(a[i].u - b[i].u, a[i].v - b[i].v));
  if (displacements_px.empty()) return std::nullopt;
  const auto middle =
      displacements_px.begin() + static_cast<std::ptrdiff_t>(displacements_px.size() / 2);
  std::nth_element(displacements_px.begin(), middle, displacements_px.end());
  return *middle;
}

}  // namespace

bool QuickBending::is_quick(const FrameResult& result) {
  if (!result.frame || !result.markers) return false;
  const std::int64_t taken_ns = result.frame->time_ns;
  const double now_s = 1e-9 * static_cast<double>(taken_ns > 0 ? taken_ns : monotonic_ns());
  const bool goes_on = result.frame->origin == source_ && now_s > before_s_;
  const auto displacement_px =
      goes_on ? median_displacement_px(before_, *result.markers) : std::nullopt;
  if (!goes_on) quick_until_s_ = -1;
  if (displacement_px && result.grey.cols > 0 &&
      *displacement_px > kQuick_per_s * result.grey.cols * (now_s - before_s_))
    quick_until_s_ = now_s + kSettles_s;
  before_ = *result.markers;
  before_s_ = now_s;
  source_ = result.frame->origin;
  return now_s <= quick_until_s_;
}

}  // namespace alltact
