// The rubber of a finger, as a scene gives it.
#pragma once

#include "core/finger/finger.h"
#include "core/simulation/fin_ray_body.h"
#include "core/simulation/mechanics/kelvin_chain.h"

namespace alltact {

struct ElasticFinger {
  double modulus_MPa = 0;
  double wall_mm = 0, base_depth_mm = 0, tip_depth_mm = 0, coupling = 0;  ///< as in FinRayGeometry
  KelvinChain chain;

  /// Error: these parameters do not make a body of that face.
  [[nodiscard]] Result<FinRayBody> body(const Face& face, double length_mm) const;
};

}  // namespace alltact
