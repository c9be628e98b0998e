#include "core/sources/v4l2/frame_check.h"

#include <algorithm>
#include <cstring>

namespace alltact {
namespace {

constexpr std::int64_t kMaxAhead_ns = 100'000'000;  // drivers with smoothed times err by less

bool has_same_bytes(const Frame& a, const Frame& b) {
  if (a.jpeg && b.jpeg) return *a.jpeg == *b.jpeg;
  if (a.grey.size() != b.grey.size()) return false;
  for (int v = 0; v < a.grey.rows; ++v)
    if (std::memcmp(a.grey.ptr(v), b.grey.ptr(v), static_cast<std::size_t>(a.grey.cols)) != 0)
      return false;
  return true;
}

bool is_uniform(const cv::Mat& grey) {
  double min = 0, max = 0;
  cv::minMaxLoc(grey, &min, &max);
  return min == max;
}

}  // namespace

FrameCheck::CaptureTime FrameCheck::time_of(std::int64_t camera_ns, std::int64_t arrived_ns) {
  CaptureTime taken_at{camera_ns, 0};
  if (camera_ns <= last_time_ns_ || camera_ns > arrived_ns + kMaxAhead_ns) {
    taken_at.correction_ns = arrived_ns - camera_ns;
    taken_at.time_ns = std::max(arrived_ns, last_time_ns_ + 1);
  }
  last_time_ns_ = taken_at.time_ns;
  return taken_at;
}

bool FrameCheck::is_repeat(const FramePtr& frame) {
  const bool is_same = last_ && has_same_bytes(*frame, *last_) && !is_uniform(frame->grey);
  last_ = frame;
  return is_same;
}

}  // namespace alltact
