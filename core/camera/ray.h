// The viewing ray of one pixel.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// Points seen by one pixel: point(z) = origin + z * direction, with origin.z = 0 and direction.z =
/// 1. The ray of a perspective camera starts at the camera's centre, or behind a flat window at a
/// lateral offset; orthographic rays are parallel to z.
struct Ray {
  Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();

  [[nodiscard]] Eigen::Vector3d point_at(double z_mm) const { return origin_mm + z_mm * direction; }
};

}  // namespace alltact
