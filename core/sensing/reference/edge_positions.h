// The pose of a finger from its face's shape alone: positions on both edges replace markers.
#pragma once

#include "core/finger/finger.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

namespace alltact {

/// Both edges of the face at every eighth valid column: small enough to store for every frame of a
/// recording.
struct EdgeCurves {
  std::vector<float> u, upper, lower;  ///< px, u ascending
  std::vector<float> along_mm;         ///< arc length of the face from its base
  bool base_at_low_u = true;
};
[[nodiscard]] EdgeCurves edge_curves(const FaceShape& shape);

/// Arc length of the face in column u, extrapolated linearly beyond the curves' ends. 0 for empty
/// curves.
[[nodiscard]] double along_mm_at(const EdgeCurves& curves, double u);

/// Middle between both edges in column u, px, extrapolated linearly beyond the ends. 0 for empty
/// curves.
[[nodiscard]] double middle_at(const EdgeCurves& curves, double u);

/// Mean distance in v, px, of two faces' edges over their common columns; infinite where these are
/// less than half of either.
[[nodiscard]] double edge_distance_px(const EdgeCurves& a, const EdgeCurves& b);

/// Positions that nearly all of the faces show, from the base to the tip. nullopt: the faces have
/// no length in common.
[[nodiscard]] std::optional<EdgePositions> choose_edge_positions(
    const std::vector<EdgeCurves>& faces);

/// The positions of one face, numbered like markers (upper edge from base to tip, then the lower
/// one). Positions outside of its valid columns are not seen.
[[nodiscard]] Markers markers_at(const EdgePositions& positions, const EdgeCurves& curves);

}  // namespace alltact
