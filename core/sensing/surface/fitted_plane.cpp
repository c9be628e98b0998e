#include "core/sensing/surface/surface_patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr std::size_t kMinPoints = 10;

struct Slopes {
  Eigen::Vector2d slope;       ///< dz/dx, dz/dy
  Eigen::Matrix2d covariance;  ///< from the noise
};

/// Fits z = a + b x + c y: the noise is along z.
std::optional<Slopes> slopes_of(const SurfacePatch& patch, bool is_moved) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const SurfacePoint& point : patch.points) middle += point.point_mm();
  middle /= static_cast<double>(patch.points.size());
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const SurfacePoint& point : patch.points) {
    const Eigen::Vector3d p = point.point_mm() - middle;
    const double z = p.z() - (is_moved ? point.common_mm : 0);
    const double weight = 1 / std::pow(std::max(point.noise_mm, 1e-6), 2);
    const Eigen::Vector3d row(1, p.x(), p.y());
    normal += weight * row * row.transpose();
    right += weight * row * z;
  }
  // A patch is neither a thousandth nor a thousand mm wide, so that the system is well scaled.
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-12)) return std::nullopt;
  const Eigen::Vector3d found = solver.solve(right);
  const Eigen::Matrix3d covariance = normal.inverse() * patch.noise_pixels;
  return Slopes{found.tail<2>(), covariance.bottomRightCorner<2, 2>()};
}

Eigen::Vector3d normal_of(const Eigen::Vector2d& slope) {
  return Eigen::Vector3d(slope.x(), slope.y(), -1).normalized();
}

}  // namespace

Result<FittedPlane> fit_plane(const SurfacePatch& patch) {
  const Error none{en::say("no plane goes through so few measured pixels, or through one line"),
                   "",
                   en::say("a larger piece, or one that is measured")};
  if (patch.points.size() < kMinPoints) return none;
  if (std::any_of(patch.points.begin(), patch.points.end(), [](const SurfacePoint& point) {
        return point.is_limit;
      }))
    return Error{en::say("a part of this piece is at a limit of what is measured"),
                 "",
                 en::say("a piece that is pressed in less deep")};
  const auto slopes = slopes_of(patch, false), if_moved = slopes_of(patch, true);
  if (!slopes || !if_moved) return none;
  FittedPlane plane;
  plane.normal = normal_of(slopes->slope);
  plane.normal_if_moved = normal_of(if_moved->slope);
  const double length = std::hypot(slopes->slope.x(), slopes->slope.y(), 1);
  Eigen::Matrix<double, 3, 2> turned;  // d normal / d slope
  turned.col(0) = (Eigen::Vector3d::UnitX() - plane.normal * plane.normal.x()) / length;
  turned.col(1) = (Eigen::Vector3d::UnitY() - plane.normal * plane.normal.y()) / length;
  plane.covariance = turned * slopes->covariance * turned.transpose();
  return plane;
}

MeasuredValue angle_deg(const FittedPlane& a, const FittedPlane& b) {
  const auto angle = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return std::atan2(p.cross(q).norm(), p.dot(q)) * 180 / std::numbers::pi;
  };
  const double between = angle(a.normal, b.normal);
  // The angle changes by the noise of both normals in their common plane. Parallel normals define
  // no plane: there the larger bound, both traces, is used.
  const Eigen::Vector3d axis = a.normal.cross(b.normal);
  double variance = 0;
  if (axis.norm() > 1e-9) {
    const Eigen::Vector3d unit = axis.normalized();
    const Eigen::Vector3d direction_a = unit.cross(a.normal), direction_b = unit.cross(b.normal);
    variance =
        direction_a.dot(a.covariance * direction_a) + direction_b.dot(b.covariance * direction_b);
  } else {
    variance = a.covariance.trace() + b.covariance.trace();
  }
  const double noise = std::sqrt(std::max(variance, 0.0)) * 180 / std::numbers::pi;
  return {between, std::hypot(noise, angle(a.normal_if_moved, b.normal_if_moved) - between)};
}

}  // namespace alltact
