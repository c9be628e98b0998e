#include "calibration/reference/reference_suspect.h"

#include "calibration/reference/spots.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace alltact {
namespace {

// next to the face's edges a shift of a tenth of a pixel is visible
constexpr double kEdgePx = 4.0;

/// 255 in columns of the face, away from its edges, where x is known.
cv::Mat inner_face(const cv::Mat& x, const FaceShape& shape) {
  cv::Mat inner(x.size(), CV_8UC1, cv::Scalar(0));
  for (int u = 0; u < x.cols; ++u) {
    const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
    if (!column.valid) continue;
    const int first = std::max(0, static_cast<int>(std::ceil(column.upper_v + kEdgePx))),
              last = std::min(x.rows - 1, static_cast<int>(column.lower_v - kEdgePx));
    for (int v = first; v <= last; ++v)
      if (std::isfinite(x.at<float>(v, u))) inner.at<std::uint8_t>(v, u) = 255;
  }
  return inner;
}

}  // namespace

std::optional<ReferenceSuspect> find_reference_suspect(const Difference& difference,
                                                       const FaceShape& shape) {
  if (difference.x.empty()) return std::nullopt;
  std::vector<double> depths;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) depths.push_back(column.z_mm);
  if (depths.empty()) return std::nullopt;
  const double mm_per_px = shape.camera().mm_per_px_at(upper_median(depths));
  const auto spot = find_spot(difference.x,
                              inner_face(difference.x, shape),
                              {.mm_per_px = {mm_per_px, mm_per_px}, .near_higher = false});
  if (!spot) return std::nullopt;
  const Eigen::Vector2d position_mm = shape.position_mm(spot->centre_px.x(), spot->centre_px.y());
  return ReferenceSuspect{spot->lower, position_mm.x(), position_mm.y(), spot->area_mm2, 0};
}

Message sentence_of(const ReferenceSuspect& suspect) {
  return en::say(
      "the face is {:.0f} % brighter than its reference {:.0f} mm from the base: something pressed "
      "there when the reference was recorded, near its frame {}; record the reference again",
      100.0 * suspect.brighter,
      suspect.along_mm,
      suspect.frame);
}

}  // namespace alltact
