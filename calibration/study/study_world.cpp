#include "calibration/study/study_world.h"

#include <cmath>
#include <cstring>

namespace alltact {
namespace {

constexpr float kPressedMm = 0.02F;

// 64-bit FNV-1a.
void mix(std::uint64_t& hash, const cv::Mat& picture) {
  const std::size_t bytes = static_cast<std::size_t>(picture.cols) * picture.elemSize();
  for (int row = 0; row < picture.rows; ++row) {
    const std::uint8_t* at = picture.ptr(row);
    for (std::size_t i = 0; i < bytes; ++i) hash = (hash ^ at[i]) * 0x100000001b3U;
  }
}

}  // namespace

std::optional<FaceZone> zone_of_press(const cv::Mat& depth_mm, bool base_at_low_u) {
  int first = depth_mm.cols, last = -1, deepest = -1;
  float greatest = kPressedMm;
  for (int v = 0; v < depth_mm.rows; ++v) {
    const auto* depth = depth_mm.ptr<float>(v);
    for (int u = 0; u < depth_mm.cols; ++u) {
      if (std::isnan(depth[u])) continue;
      first = std::min(first, u);
      last = std::max(last, u);
      if (depth[u] > greatest) greatest = depth[u], deepest = u;
    }
  }
  if (deepest < 0) return std::nullopt;
  int third = 3 * (deepest - first) / (last - first + 1);
  if (!base_at_low_u) third = 2 - third;
  return static_cast<FaceZone>(third);
}

std::uint64_t checksum_of(const std::vector<StudyFrame>& frames) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const StudyFrame& frame : frames) {
    mix(hash, frame.picture->grey);
    mix(hash, frame.depth_mm);
  }
  return hash;
}

}  // namespace alltact
