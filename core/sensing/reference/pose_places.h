// The pose of a finger by its face's shape alone: places on both edges that stand in for markers.
#pragma once

#include "core/finger/finger.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

namespace alltact {

/// Both edges of the face at every eighth column that is trusted: small enough to be kept of every
/// frame of a recording.
struct EdgeCurves {
  std::vector<float> u, upper, lower;  ///< px, u ascending
  std::vector<float> along_mm;         ///< length of the face from its base
  bool base_at_low_u = true;
};
[[nodiscard]] EdgeCurves edge_curves(const FaceShape& shape);

/// Length of the face in column u, going on evenly beyond the curves' ends. 0 for empty curves.
[[nodiscard]] double along_mm_at(const EdgeCurves& curves, double u);

/// Half-way between both edges in column u, px, going on evenly beyond the ends. 0 for empty
/// curves.
[[nodiscard]] double middle_at(const EdgeCurves& curves, double u);

/// Mean distance in v, px, of two faces' edges over the columns that both have; infinite where that
/// is less than half of either.
[[nodiscard]] double edge_distance_px(const EdgeCurves& a, const EdgeCurves& b);

/// Places that nearly all of the faces show, from the base to the tip. nullopt: there are none,
/// because the faces have no length in common.
[[nodiscard]] std::optional<PosePlaces> choose_places(const std::vector<EdgeCurves>& faces);

/// The places of one face, numbered like markers (upper edge from base to tip, then the lower one);
/// those beyond its trusted columns are not seen.
[[nodiscard]] Markers markers_at(const PosePlaces& places, const EdgeCurves& curves);

}  // namespace alltact
