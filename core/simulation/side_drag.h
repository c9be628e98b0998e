// Displacement of a side face, with its dots, under a push.
#pragma once

#include "core/simulation/mechanics/half_space_contact.h"
#include "core/simulation/mechanics/point_force.h"

#include <vector>

namespace alltact {

struct SideDrag {
  int side = -1;         ///< -1: upper (small v), +1: lower
  SurfaceFrame surface;  ///< at the contact's centre
  HalfSpaceContact contact;
};

/// Displacement of a side face's point under all pushes on that face; camera frame, mm.
[[nodiscard]] inline Eigen::Vector3d side_displacement_mm(const std::vector<SideDrag>& drags,
                                                          int side,
                                                          const Eigen::Vector3d& point_mm) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const SideDrag& drag : drags) {
    if (drag.side != side) continue;
    const SurfaceFrame& at = drag.surface;
    const Eigen::Vector3d from = point_mm - at.point_mm;
    const Eigen::Vector3d moved =
        drag.contact.displacement_mm({from.dot(at.along), from.dot(at.across)});
    sum += moved.x() * at.along + moved.y() * at.across + moved.z() * at.into;
  }
  return sum;
}

}  // namespace alltact
