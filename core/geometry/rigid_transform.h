// Where one frame lies in another.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace alltact {

/// Takes what is known in one frame to another: p_to = R(rotation) p_from + translation_mm.
/// `gripper_from_camera` takes camera coordinates to the gripper's: its translation is where the
/// camera sits in the gripper, the columns of its matrix are the camera's axes there.
struct RigidTransform {
  /// Hamilton's, active; finite and not 0. Where it is used it counts with unit length.
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

/// Turns about the axes x, y and z of the frame that is led to, in this order: R = Rz Ry Rx.
[[nodiscard]] Eigen::Quaterniond rotation_of_degrees(const Eigen::Vector3d& about_xyz_deg);

/// The same angles back, x and z in [-180, 180], y in [-90, 90]. Where y is 90 or -90 the other two
/// turn about one axis: z is 0 there.
[[nodiscard]] Eigen::Vector3d degrees_of(const Eigen::Quaterniond& rotation);

}  // namespace alltact
