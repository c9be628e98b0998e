// Jumps of the face's outline: a finger that is bent until one part of it hides another.
#pragma once

#include "core/sensing/face/face_edges.h"

#include <optional>

namespace alltact {

/// Transition of the outline from one part of the face to another that is nearer or further away.
struct OutlineJump {
  /// Middle between the last trusted column of one part and the first of the other
  double u_px;
  double
      shorter_fraction;    ///< fraction of the trusted columns on the side that has fewer, 0 to 0.5
  bool shorter_at_high_u;  ///< the side with fewer is at large u
};

/// The largest permanent jump of both edges in opposite directions. It is at least 5 % of the
/// face's width in the image, and far more than bend and scatter on either side. An object over
/// both edges makes a jump that returns, which does not count. A column is trusted where both edges
/// are. nullopt: no jump with two trusted columns or more on either side and a gap of less than a
/// tenth of the outline.
[[nodiscard]] std::optional<OutlineJump> outline_jump(const FaceEdges& edges);

/// The edges without the shorter side of a jump: its samples are invalid, and its end is unset.
[[nodiscard]] FaceEdges longer_side(FaceEdges edges, const OutlineJump& jump);

}  // namespace alltact
