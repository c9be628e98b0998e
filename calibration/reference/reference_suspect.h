// A finger that contradicts its reference: skin that is brighter than it ever is untouched accuses
// the reference, in which something pressed there.
#pragma once

#include "core/message.h"
#include "core/sensing/depth/local_depth.h"

#include <optional>

namespace alltact {

struct ReferenceSuspect {
  double brighter = 0;  ///< than the reference, 0.1: by 10 %
  double along_mm = 0;  ///< the middle of the spot, from the base
  double area_mm2 = 0;
  int frame = 0;  ///< number in the reference recording of the frame nearest to the pose
};

/// Searches x for a compact spot, 1 to 150 mm^2, that is brighter than its surroundings by 3 % and
/// by 8 standard deviations. A bright rim around something that presses is none: a spot has no
/// part that is as much darker within 4 mm. nullopt: there is none, or the pose is not known.
[[nodiscard]] std::optional<ReferenceSuspect> find_reference_suspect(const Difference& difference,
                                                                     const Reference& reference,
                                                                     const FaceShape& shape);

/// What happened, where, and what to do.
[[nodiscard]] Message sentence_of(const ReferenceSuspect& suspect);

}  // namespace alltact
