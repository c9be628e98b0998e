#include "core/sensing/stationary_contact.h"

#include "core/geometry/ball.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {
namespace {

constexpr int kCellStride = 4;  // px; a contact is dozens wide
constexpr double kMiddleThreshold =
    0.6;  // threshold for the patch's middle, as a fraction of the maximum

/// Number of cells of the coarse grid that are above `level` and connected with the one at `from`.
int connected_cells(const cv::Mat& x, cv::Point from, float level) {
  const cv::Size size((x.cols + kCellStride - 1) / kCellStride,
                      (x.rows + kCellStride - 1) / kCellStride);
  cv::Mat seen(size, CV_8UC1, cv::Scalar(0));
  std::vector<cv::Point> waiting{from};
  int count = 0;
  while (!waiting.empty()) {
    const cv::Point at = waiting.back();
    waiting.pop_back();
    if (!cv::Rect({}, size).contains(at) || seen.at<std::uint8_t>(at) != 0) continue;
    seen.at<std::uint8_t>(at) = 1;
    if (!(x.at<float>(at * kCellStride) > level)) continue;
    ++count;
    for (const cv::Point step : {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}})
      waiting.push_back(at + step);
  }
  return count;
}

double disc_radius_mm(const cv::Mat& x, const FaceShape& shape, const DarkPatch& patch) {
  const auto area = shape.pixel_area(patch.pixel.x(), patch.pixel.y());
  if (!area) return 0;
  const cv::Point from(static_cast<int>(patch.pixel.x()) / kCellStride,
                       static_cast<int>(patch.pixel.y()) / kCellStride);
  const int cells = connected_cells(x, from, static_cast<float>(kDiscLevel * patch.darkness));
  return std::sqrt(cells * kCellStride * kCellStride * area->on_face_mm2 / M_PI);
}

}  // namespace

std::optional<DarkPatch> dark_patch(const FrameResult& result) {
  const bool is_measured = result.shape && (result.depth || result.difference);
  if (!is_measured || is_face_pressed(result) != true) return std::nullopt;
  const cv::Mat& x = result.depth ? result.depth->depth_mm : result.difference->x;
  // The mean of the largest values, because a single pixel is noise.
  std::vector<float> values;
  for (int v = 0; v < x.rows; v += kCellStride)
    for (int u = 0; u < x.cols; u += kCellStride)
      if (const float value = x.at<float>(v, u); value > 0) values.push_back(value);
  const std::size_t top = std::max<std::size_t>(8, values.size() / 200);
  if (values.size() < 4 * top) return std::nullopt;
  std::nth_element(values.begin(), values.end() - static_cast<std::ptrdiff_t>(top), values.end());
  DarkPatch patch;
  for (std::size_t i = values.size() - top; i < values.size(); ++i)
    patch.darkness += static_cast<double>(values[i]) / static_cast<double>(top);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double weight = 0;
  for (int v = 0; v < x.rows; v += kCellStride)
    for (int u = 0; u < x.cols; u += kCellStride) {
      const auto value = static_cast<double>(x.at<float>(v, u));
      if (!(value > kMiddleThreshold * patch.darkness)) continue;
      middle += value * Eigen::Vector2d(u, v);
      weight += value;
    }
  if (!(weight > 0)) return std::nullopt;
  patch.pixel = middle / weight;
  patch.position_mm = result.shape->position_mm(patch.pixel.x(), patch.pixel.y());
  patch.disc_radius_mm = disc_radius_mm(x, *result.shape, patch);
  return patch;
}

bool StationaryContactDetector::add(const std::optional<DarkPatch>& patch, double time_s) {
  hold_ = {};
  if (!patch) {
    seen_.clear();
    taken_.reset();
    return false;
  }
  if (!seen_.empty() && time_s - seen_.back().time_s > kMaxGap_s) seen_.clear();
  seen_.push_back({time_s, *patch});
  if (taken_ && (patch->position_mm - taken_->position_mm).norm() < kMinMovement_mm) {
    hold_.state = HoldState::kTaken;
    return false;
  }
  taken_.reset();
  const auto distance_mm = [&](const Seen& one) {
    return (one.patch.position_mm - patch->position_mm).norm();
  };
  const auto moved = [&](const Seen& one) {
    return distance_mm(one) > kMaxMovement_mm ||
           std::abs(one.patch.darkness - patch->darkness) > kMaxChange * patch->darkness;
  };
  const auto last_moved = std::find_if(seen_.rbegin(), seen_.rend(), moved);
  for (const Seen& one : seen_) hold_.moved_mm = std::max(hold_.moved_mm, distance_mm(one));
  hold_.state = last_moved == seen_.rend() ? HoldState::kHolds : HoldState::kMoves;
  seen_.erase(seen_.begin(), last_moved.base());
  hold_.hold_fraction = std::min(1.0, (time_s - seen_.front().time_s) / kHold_s);
  if (hold_.hold_fraction < 1 || seen_.size() < kMinFrames) return false;
  taken_ = *patch;
  seen_.clear();
  return true;
}

}  // namespace alltact
