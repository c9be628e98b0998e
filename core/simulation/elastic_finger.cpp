#include "core/simulation/elastic_finger.h"

namespace alltact {

Result<FinRayBody> ElasticFinger::body(const Face& face, double length_mm) const {
  return FinRayBody::create(
      {length_mm, face.width_mm, face.layer_mm, wall_mm, base_depth_mm, tip_depth_mm, coupling},
      modulus_MPa);
}

}  // namespace alltact
