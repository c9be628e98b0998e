// A load on the finger, from the pushing effect to the body that carries it.
#pragma once

#include "core/simulation/mechanics/point_force.h"

#include <functional>
#include <optional>

namespace alltact {

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
