// A force at a position on the finger's surface.
#pragma once

#include "core/finger/finger.h"

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// Rotates and moves with the finger, like the force of an object in contact with its surface.
/// `across` is measured from the face's middle line: on the contact and the back face towards +y,
/// on the side faces towards the contact face. A side face's middle line is halfway between view
/// face and back.
struct PointForce {
  PushedFace face = PushedFace::kContact;
  double s_mm = 0;  ///< of its section, along the view face from its base
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

/// A frame at a position on the finger's surface: camera frame, mm; three orthogonal unit vectors.
struct SurfaceFrame {
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d into = Eigen::Vector3d::UnitX();   ///< into the finger, along its normal
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();  ///< towards the tip
  Eigen::Vector3d across = Eigen::Vector3d::UnitX();

  [[nodiscard]] Eigen::Vector3d vector_N(const PointForce& force) const {
    return force.normal_N * into + force.along_N * along + force.across_N * across;
  }
};

// A load on the finger, from the pushing effect to the body that carries it.

/// The pushing effect adds it to the face before the body (EffectKind::rank) responds. Without a
/// body there is no response: the finger is rigid.
struct FaceLoad {
  /// The force `frame_offset` frames after frame `frame`; zero before the push begins.
  std::function<PointForce(int frame, double frame_offset)> at;
  const void* source = nullptr;  ///< identifies the effect

  struct Response {
    PointForce force;      ///< the force that the finger carries
    SurfaceFrame surface;  ///< where the force acts after deflection
    double modulus_MPa;    ///< of the body
  };
  std::optional<Response> response;
};

}  // namespace alltact
