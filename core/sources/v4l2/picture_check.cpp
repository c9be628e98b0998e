#include "core/sources/v4l2/picture_check.h"

#include <algorithm>
#include <cstring>

namespace alltact {
namespace {

constexpr std::int64_t kMostAhead_ns = 100'000'000;  // drivers that smooth their times err by less

bool has_same_bytes(const Frame& a, const Frame& b) {
  if (a.jpeg && b.jpeg) return *a.jpeg == *b.jpeg;
  if (a.grey.size() != b.grey.size()) return false;
  for (int v = 0; v < a.grey.rows; ++v)
    if (std::memcmp(a.grey.ptr(v), b.grey.ptr(v), static_cast<std::size_t>(a.grey.cols)) != 0)
      return false;
  return true;
}

bool is_one_brightness(const cv::Mat& grey) {
  double least = 0, most = 0;
  cv::minMaxLoc(grey, &least, &most);
  return least == most;
}

}  // namespace

PictureCheck::Told PictureCheck::time_of(std::int64_t told_ns, std::int64_t arrived_ns) {
  Told told{told_ns, 0};
  if (told_ns <= last_time_ns_ || told_ns > arrived_ns + kMostAhead_ns) {
    told.late_ns = arrived_ns - told_ns;
    told.time_ns = std::max(arrived_ns, last_time_ns_ + 1);
  }
  last_time_ns_ = told.time_ns;
  return told;
}

bool PictureCheck::is_repeat(const FramePtr& frame) {
  const bool is_same = last_ && has_same_bytes(*frame, *last_) && !is_one_brightness(frame->grey);
  last_ = frame;
  return is_same;
}

}  // namespace alltact
