#include "core/sensing/surface/read_patch.h"

#include "core/sensing/depth/depth_sd.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kMaxPoints = 1500;

/// nullopt off the face.
std::optional<SurfacePoint> point_at(
    const FrameResult& result, const Face& face, int u, int v, const DepthErrorTerms& causes) {
  const auto local = result.shape->at(u, v);
  const auto area = result.shape->pixel_area(u, v);
  if (!local || !area) return std::nullopt;
  SurfacePoint point;
  point.untouched_mm = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
  point.depth_mm = static_cast<double>(result.depth->depth_mm.at<float>(v, u));
  point.noise_mm = std::hypot(causes.noise, causes.lateral);
  point.common_mm = std::hypot(causes.mapping, causes.reference, causes.light);
  point.is_limit = is_at_limit(result.depth->flags.at<std::uint8_t>(v, u));
  point.on_face_mm2 = area->on_face_mm2;
  point.projected_mm2 = area->projected_mm2;
  return point;
}

bool is_measured(const FrameResult& result) {
  return result.depth && result.reference && result.shape;
}

}  // namespace

SurfacePatch patch_in(const FrameResult& result,
                      const Face& face,
                      const Mapping& mapping,
                      double smoothing_px,
                      const cv::Rect& box) {
  SurfacePatch patch;
  if (!is_measured(result)) return patch;
  const cv::Rect inside = box & cv::Rect({}, result.depth->depth_mm.size());
  const int step = std::max(1, static_cast<int>(std::ceil(std::sqrt(inside.area() / kMaxPoints))));
  const double pixels = static_cast<double>(step) * step;
  patch.noise_pixels = std::max(1.0, noise_pixels_of_area(smoothing_px) / pixels);
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, mapping);
  for (int v = inside.y; v < inside.y + inside.height; v += step)
    for (int u = inside.x; u < inside.x + inside.width; u += step) {
      const auto depth_mm = static_cast<double>(result.depth->depth_mm.at<float>(v, u));
      if (!std::isfinite(depth_mm)) continue;
      auto point = point_at(result, face, u, v, error.of_depth(u, v, depth_mm));
      if (!point) continue;
      point->on_face_mm2 *= pixels;
      point->projected_mm2 *= pixels;
      patch.points.push_back(*point);
    }
  return patch;
}

SurfaceLine line_between(const FrameResult& result,
                         const Face& face,
                         const Mapping& mapping,
                         double smoothing_px,
                         cv::Point2d from,
                         cv::Point2d to) {
  SurfaceLine line;
  if (!is_measured(result)) return line;
  line.patch.noise_pixels = noise_pixels_of_row(smoothing_px);
  const cv::Rect image({}, result.depth->depth_mm.size());
  const cv::Point2d delta = to - from;
  const int steps = static_cast<int>(std::ceil(std::max(std::abs(delta.x), std::abs(delta.y))));
  DepthErrorModel error(*result.depth, *result.reference, *result.shape, mapping);
  double along_mm = 0;
  for (int i = 0; i <= steps; ++i) {
    const cv::Point2d at = from + delta * (static_cast<double>(i) / std::max(steps, 1));
    const int u = static_cast<int>(std::lround(at.x)), v = static_cast<int>(std::lround(at.y));
    if (!image.contains({u, v})) continue;
    const auto depth_mm = static_cast<double>(result.depth->depth_mm.at<float>(v, u));
    if (!std::isfinite(depth_mm)) continue;
    const auto point = point_at(result, face, u, v, error.of_depth(u, v, depth_mm));
    if (!point) continue;
    auto& points = line.patch.points;
    if (!points.empty()) along_mm += (point->untouched_mm - points.back().untouched_mm).norm();
    points.push_back(*point);
    line.along_mm.push_back(along_mm);
  }
  return line;
}

}  // namespace alltact
