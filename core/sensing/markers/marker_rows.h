// Which of many dots are the row of markers: the ones that lie evenly and look alike.
#pragma once

#include "core/sensing/face/side_edges.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

namespace alltact {

/// A row of dots from base to tip, as indices into the dots it was chosen from.
struct DotRow {
  std::vector<int> dots;
  double unevenness = 0;  ///< mean over the row of changes in step, size and contrast; 0: perfect
};

/// A row above this unevenness is not one: a dot left out or a false one taken in costs more.
inline constexpr double kMaxUnevenness = 0.25;

/// Says of each dot where it lies on the finger (along_mm, face_px, off_face): the side faces are
/// taken for what lies before the face's edges in the direction of y, so that a dot's ray meets its
/// side face in one point, and its foot on the face is the point nearest to that.
void place_on_finger(std::vector<Dot>& dots, const FaceShape& shape, const SideEdges& edges);

/// The most even choice, judged in millimetres along the finger rather than in pixels, of `per_row`
/// dots of one side, in the order of u from base to tip, by dynamic programming over pairs of
/// neighbours. nullopt where there are fewer dots than that.
[[nodiscard]] std::optional<DotRow> choose_row(const std::vector<Dot>& dots,
                                               bool upper,
                                               int per_row,
                                               bool base_at_low_u);

/// The dots of both rows in the order of the markers' numbers; nullopt where a row is not plain.
[[nodiscard]] std::optional<std::vector<Dot>> two_rows(const std::vector<Dot>& dots,
                                                       int per_row,
                                                       bool base_at_low_u);

}  // namespace alltact
