#include "core/sensing/contact/push.h"

#include <array>
#include <numbers>

namespace alltact {
namespace {

PushedFace nearest_face(const Eigen::Vector2d& direction, bool base_at_low_u) {
  const double towards_tip = base_at_low_u ? direction.x() : -direction.x();
  if (std::abs(towards_tip) >= std::abs(direction.y()))
    return towards_tip > 0 ? PushedFace::kContact : PushedFace::kBack;
  return direction.y() > 0 ? PushedFace::kUpper : PushedFace::kLower;
}

}  // namespace

Push push_of(const Markers& markers, const ContactSettings& settings, bool base_at_low_u) {
  Push result;
  result.offset_px.setZero();
  const auto& rest = settings.rest_markers;
  if (markers.empty() || markers.size() != rest.size()) return result;
  double variance = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    result.offset_px += Eigen::Vector2d(markers[m].u, markers[m].v) - rest[m];
    variance += markers[m].sd_px * markers[m].sd_px;
  }
  const double length = result.offset_px.norm();
  if (!std::isfinite(length)) {
    result.offset_px.setZero();
    return result;
  }
  result.pushed = length > settings.threshold_px && length > 0;
  if (!result.pushed) return result;
  const Eigen::Vector2d direction = result.offset_px / length;
  result.direction = Eigen::Vector3d(direction.x(), direction.y(), 0.0);
  // Root of the sum of the variances is sd_marker * sqrt(number of markers).
  result.sd_deg = std::sqrt(variance) / length * 180.0 / std::numbers::pi;
  result.face = nearest_face(direction, base_at_low_u);
  return result;
}

}  // namespace alltact
