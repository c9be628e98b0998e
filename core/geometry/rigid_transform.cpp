#include "core/geometry/rigid_transform.h"

#include <cmath>
#include <numbers>

namespace alltact {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

RigidTransform RigidTransform::inverse() const {
  const Eigen::Quaterniond back = rotation.normalized().conjugate();
  return {back, -(back * translation_mm)};
}

Eigen::Quaterniond rotation_from_rpy_deg(const Eigen::Vector3d& about_xyz_deg) {
  const Eigen::Vector3d angle = about_xyz_deg * kDegree;
  return Eigen::AngleAxisd(angle.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angle.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angle.x(), Eigen::Vector3d::UnitX());
}

Eigen::Vector3d rpy_deg(const Eigen::Quaterniond& rotation) {
  constexpr double kUpright = 1e-7;  // cosine of y; below it x and z are indistinguishable
  const Eigen::Matrix3d r = rotation.normalized().toRotationMatrix();
  const double cosine = std::hypot(r(0, 0), r(1, 0));
  const double y = std::atan2(-r(2, 0), cosine);
  const bool is_upright = cosine < kUpright;
  const double x = is_upright ? std::atan2(-r(1, 2), r(1, 1)) : std::atan2(r(2, 1), r(2, 2));
  const double z = is_upright ? 0 : std::atan2(r(1, 0), r(0, 0));
  return Eigen::Vector3d(x, y, z) / kDegree;
}

}  // namespace alltact
