#include "core/live/stationary_contact.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kStride = 4;      // px; a contact is dozens wide
constexpr double kInner = 0.6;  // of the greatest: what counts as the patch's middle
constexpr double kMostGap_s = 0.3;

}  // namespace

std::optional<DarkPatch> dark_patch(const FrameResult& result) {
  const bool is_measured = result.shape && (result.depth || result.difference);
  if (!is_measured || result.touch != FaceTouch::kTouched) return std::nullopt;
  const cv::Mat& x = result.depth ? result.depth->depth_mm : result.difference->x;
  // The mean of the largest: a single pixel is noise.
  std::vector<float> values;
  for (int v = 0; v < x.rows; v += kStride)
    for (int u = 0; u < x.cols; u += kStride)
      if (const float value = x.at<float>(v, u); value > 0) values.push_back(value);
  const std::size_t top = std::max<std::size_t>(8, values.size() / 200);
  if (values.size() < 4 * top) return std::nullopt;
  std::nth_element(values.begin(), values.end() - static_cast<std::ptrdiff_t>(top), values.end());
  DarkPatch patch;
  for (std::size_t i = values.size() - top; i < values.size(); ++i)
    patch.darkness += static_cast<double>(values[i]) / static_cast<double>(top);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double weight = 0;
  for (int v = 0; v < x.rows; v += kStride)
    for (int u = 0; u < x.cols; u += kStride) {
      const auto value = static_cast<double>(x.at<float>(v, u));
      if (!(value > kInner * patch.darkness)) continue;
      middle += value * Eigen::Vector2d(u, v);
      weight += value;
    }
  if (!(weight > 0)) return std::nullopt;
  middle /= weight;
  patch.place_mm = result.shape->place_mm(middle.x(), middle.y());
  return patch;
}

bool StationaryContactDetector::add(const std::optional<DarkPatch>& patch, double time_s) {
  if (!patch) {
    seen_.clear();
    taken_.reset();
    return false;
  }
  if (!seen_.empty() && time_s - seen_.back().time_s > kMostGap_s) seen_.clear();
  seen_.push_back({time_s, *patch});
  if (taken_ && (patch->place_mm - taken_->place_mm).norm() < kApart_mm) return false;
  taken_.reset();
  const auto moved = [&](const Seen& one) {
    return (one.patch.place_mm - patch->place_mm).norm() > kMost_mm ||
           std::abs(one.patch.darkness - patch->darkness) > kMostChange * patch->darkness;
  };
  while (moved(seen_.front())) seen_.pop_front();
  if (time_s - seen_.front().time_s < kHold_s) return false;
  taken_ = *patch;
  seen_.clear();
  return true;
}

}  // namespace alltact
