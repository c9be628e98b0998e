// A finger that contradicts its reference: skin that is brighter than it ever is untouched accuses
// the reference, in which something pressed there.
#pragma once

#include "core/message.h"
#include "core/sensing/depth/local_depth.h"

#include <optional>

namespace alltact {

struct ReferenceSuspect {
  double brighter = 0;   ///< than the reference, 0.1: by 10 %
  double along_mm = 0;   ///< the middle of the spot, from the base
  double across_mm = 0;  ///< and from the middle line
  double area_mm2 = 0;
  int frame = 0;  ///< number in the reference recording of the frame nearest to the pose
};

/// The spot of x (spots.h) that is brightest. A bright rim around something that presses is none.
/// For poses that the reference knows; `frame` is left to those who know it.
[[nodiscard]] std::optional<ReferenceSuspect> find_reference_suspect(const Difference& difference,
                                                                     const FaceShape& shape);

/// What happened, where, and what to do.
[[nodiscard]] Message sentence_of(const ReferenceSuspect& suspect);

}  // namespace alltact
