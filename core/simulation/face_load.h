// A push on the finger on its way from who pushes to the body that bears it.
#pragma once

#include "core/simulation/mechanics/point_force.h"

#include <functional>
#include <optional>

namespace alltact {

/// Added to the face by what pushes, before the body (EffectKind::rank) answers it. Without a body
/// there is no answer: the finger stands firm.
struct FaceLoad {
  /// At a moment so many frames after frame `frame`; nothing where it does not push yet.
  std::function<PointForce(int frame, double later)> at;
  const void* source = nullptr;  ///< tells whose it is

  struct Borne {
    PointForce force;      ///< what of it the finger bears
    SurfaceFrame surface;  ///< where that stands now
    double modulus_MPa;    ///< of the body
  };
  std::optional<Borne> borne;
};

}  // namespace alltact
