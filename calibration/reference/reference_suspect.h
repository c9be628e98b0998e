// A contradiction between a finger and its reference: skin brighter than ever untouched indicates a
// contact during the recording of the reference.
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

/// The brightest spot of x (spots.h). A bright rim around a contact does not count. For poses
/// inside the reference; the caller sets `frame`.
[[nodiscard]] std::optional<ReferenceSuspect> find_reference_suspect(const Difference& difference,
                                                                     const FaceShape& shape);

/// What happened, where, and what to do.
[[nodiscard]] Message sentence_of(const ReferenceSuspect& suspect);

}  // namespace alltact
