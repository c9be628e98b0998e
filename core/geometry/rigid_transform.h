// The pose of one frame in another.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace alltact {

/// Maps coordinates of one frame to another: p_to = R(rotation) p_from + translation_mm.
/// `gripper_from_camera` maps camera coordinates to the gripper's: its translation is the camera's
/// position in the gripper, the columns of its matrix are the camera's axes there.
struct RigidTransform {
  /// Hamilton's, active; finite and not 0. It is normalised on use.
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation_mm = Eigen::Vector3d::Zero();

  [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& from) const {
    return rotation.normalized() * from;
  }
  [[nodiscard]] Eigen::Vector3d point(const Eigen::Vector3d& from_mm) const {
    return direction(from_mm) + translation_mm;
  }
  [[nodiscard]] RigidTransform inverse() const;
  /// c_from_b * b_from_a = c_from_a.
  [[nodiscard]] RigidTransform operator*(const RigidTransform& first) const {
    return {rotation.normalized() * first.rotation.normalized(), point(first.translation_mm)};
  }
  bool operator==(const RigidTransform& other) const {
    return rotation.coeffs() == other.rotation.coeffs() && translation_mm == other.translation_mm;
  }
};

/// Rotations about the fixed axes x, y and z of the target frame, in this order: R = Rz Ry Rx.
[[nodiscard]] Eigen::Quaterniond rotation_from_rpy_deg(const Eigen::Vector3d& about_xyz_deg);

/// The inverse: x and z in [-180, 180], y in [-90, 90]. Where y is 90 or -90 the other two rotate
/// about one axis; z is 0 there.
[[nodiscard]] Eigen::Vector3d rpy_deg(const Eigen::Quaterniond& rotation);

}  // namespace alltact
