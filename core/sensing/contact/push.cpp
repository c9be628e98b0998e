#include "core/sensing/contact/push.h"

#include <array>
#include <numbers>

namespace alltact {
namespace {

PushedFace face_towards(const Eigen::Vector2d& direction, bool base_at_low_u) {
  const double towards_tip = base_at_low_u ? direction.x() : -direction.x();
  if (std::abs(towards_tip) >= std::abs(direction.y()))
    return towards_tip > 0 ? PushedFace::kContact : PushedFace::kBack;
  return direction.y() > 0 ? PushedFace::kUpper : PushedFace::kLower;
}

}  // namespace

Eigen::MatrixXd displacement_covariance_px2(const Markers& markers,
                                            const std::optional<Eigen::MatrixXd>& now_px2) {
  double seen_square = 0, seen = 0;
  for (const Marker& marker : markers)
    if (marker.seen) seen_square += marker.sd_px * marker.sd_px, ++seen;
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  Eigen::MatrixXd covariance = now_px2 ? *now_px2 : Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index k = 0; k < size; ++k) {
    const Marker& marker = markers[static_cast<std::size_t>(k / 2)];
    const double own = marker.sd_px * marker.sd_px;
    if (!now_px2) covariance(k, k) += own;
    covariance(k, k) += marker.seen || seen == 0 ? own : seen_square / seen;
  }
  return covariance;
}

Push push_of(const Markers& markers,
             const ContactSettings& settings,
             bool base_at_low_u,
             const Eigen::MatrixXd& displacement_cov_px2) {
  Push result;
  result.offset_px.setZero();
  const auto& rest = settings.rest_markers;
  if (markers.empty() || markers.size() != rest.size()) return result;
  for (std::size_t m = 0; m < markers.size(); ++m)
    result.offset_px += Eigen::Vector2d(markers[m].u, markers[m].v) - rest[m];
  const double length = result.offset_px.norm();
  if (!std::isfinite(length)) {
    result.offset_px.setZero();
    return result;
  }
  const Eigen::MatrixXd covariance = displacement_cov_px2.size() == 0
                                         ? displacement_covariance_px2(markers)
                                         : displacement_cov_px2;
  for (Eigen::Index i = 0; i < covariance.rows(); i += 2)
    for (Eigen::Index k = 0; k < covariance.cols(); k += 2)
      result.offset_covariance_px2 += covariance.block<2, 2>(i, k);
  result.pushed = length > settings.threshold_px && length > 0;
  if (!result.pushed) return result;
  const Eigen::Vector2d direction = result.offset_px / length;
  const Eigen::Vector2d across(-direction.y(), direction.x());
  result.direction = Eigen::Vector3d(direction.x(), direction.y(), 0.0);
  result.sd_deg = std::sqrt(across.dot(result.offset_covariance_px2 * across)) / length * 180.0 /
                  std::numbers::pi;
  result.face = face_towards(direction, base_at_low_u);
  return result;
}

}  // namespace alltact
