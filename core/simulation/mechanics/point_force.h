// A force at a place on the finger's surface.
#pragma once

#include "core/finger/pushed_face.h"

#include <Eigen/Core>

namespace alltact {

/// Turns and moves with the finger, as the force of a thing does that touches its skin. `across`
/// is measured from the face's middle line: on the contact and the back face towards +y, on the
/// side faces (their middle line is half-way between view face and back) towards the contact face.
struct PointForce {
  PushedFace face = PushedFace::kContact;
  double s_mm = 0;  ///< of the section that it stands on, along the view face from its base
  double across_mm = 0;
  double normal_N = 0;  ///< into the finger
  double along_N = 0;   ///< towards the tip
  double across_N = 0;

  [[nodiscard]] PointForce times(double share) const {
    PointForce part = *this;
    part.normal_N *= share, part.along_N *= share, part.across_N *= share;
    return part;
  }
};

/// A place on the finger's surface in space: camera frame, mm; three unit vectors at right angles.
struct SurfaceFrame {
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d into = Eigen::Vector3d::UnitX();   ///< the finger, along its normal
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();  ///< towards the tip
  Eigen::Vector3d across = Eigen::Vector3d::UnitX();

  [[nodiscard]] Eigen::Vector3d vector_N(const PointForce& force) const {
    return force.normal_N * into + force.along_N * along + force.across_N * across;
  }
};

}  // namespace alltact
