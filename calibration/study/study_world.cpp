#include "calibration/study/study_world.h"

#include "core/numerics/checksum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr float kMinPressMm = 0.02F;

void add_image(Checksum& checksum, const cv::Mat& image) {
  const std::size_t bytes = static_cast<std::size_t>(image.cols) * image.elemSize();
  for (int row = 0; row < image.rows; ++row) checksum.add(image.ptr(row), bytes);
}

}  // namespace

std::optional<FaceZone> zone_of_press(const cv::Mat& depth_mm, const cv::Mat& view_z_mm) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = -nearest;
  float greatest = kMinPressMm;
  std::optional<float> z;  // where it is deepest
  for (int v = 0; v < depth_mm.rows; ++v) {
    const auto* depth = depth_mm.ptr<float>(v);
    const auto* view_z = view_z_mm.ptr<float>(v);
    for (int u = 0; u < depth_mm.cols; ++u) {
      if (std::isnan(view_z[u])) continue;
      nearest = std::min(nearest, view_z[u]);
      farthest = std::max(farthest, view_z[u]);
      if (depth[u] > greatest) greatest = depth[u], z = view_z[u];
    }
  }
  if (!z) return std::nullopt;
  const float part = (*z - nearest) / std::max(farthest - nearest, 1e-6F);
  return static_cast<FaceZone>(std::clamp(static_cast<int>(3 * part), 0, 2));
}

std::uint64_t checksum_of(const std::vector<StudyFrame>& frames) {
  Checksum checksum;
  for (const StudyFrame& frame : frames) {
    add_image(checksum, frame.image->grey);
    add_image(checksum, frame.depth_mm);
  }
  return checksum.value();
}

}  // namespace alltact
