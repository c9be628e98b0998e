// Where the face's outline jumps: a finger that is bent until one part of it hides another.
#pragma once

#include "core/sensing/face/face_edges.h"

#include <optional>

namespace alltact {

/// Where the outline goes over from one part of the face to another that lies nearer or further
/// away.
struct OutlineJump {
  double u_px;          ///< half-way from the last trusted column of one part to the other's first
  double shorter_part;  ///< of the trusted columns: what lies on the side that has fewer, 0 to 0.5
  bool shorter_at_high_u;  ///< that side is the one at large u
};

/// The largest jump of both edges in opposite directions that stays: by 5 % or more of the face's
/// width in the picture, and by much more than they bend and scatter on either side. What
/// something that lies over both edges makes goes back again, and is none. A column is trusted
/// where both edges are. nullopt: there is none with two trusted columns or more on either side,
/// and no wider gap between them than a tenth of the outline.
[[nodiscard]] std::optional<OutlineJump> outline_jump(const FaceEdges& edges);

/// The edges without what lies on the shorter side of a jump: nothing is trusted there, and the
/// face's end there was not seen.
[[nodiscard]] FaceEdges longer_side(FaceEdges edges, const OutlineJump& jump);

}  // namespace alltact
