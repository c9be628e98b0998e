// Scales the mapping's output to millimetres along z where these differ by a factor only.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/face/face_shape.h"

#include <vector>

namespace alltact {

/// Factor of every pixel: the mapping's variation over the face. For a mapping of projected depths
/// also the ratio of the path along z to that along the normal. Made for one frame.
class DepthScale {
 public:
  DepthScale(const MappingParameters& mapping, const FaceShape& shape);

  /// True when the factor is 1 everywhere.
  [[nodiscard]] bool is_one() const { return by_column_.empty(); }
  /// Multiplies the depths of row v from column `first` on; not to be called when is_one().
  void scale(int v, int first, int count, float* depth_mm) const;

 private:
  std::vector<float> by_column_;                          // in the middle of the face
  std::vector<float> across_, middle_v_, across_per_px_;  // empty unless the factor varies across
};

}  // namespace alltact
