// Numbering dots as the source paper does: two rows, each sorted along the picture, hidden markers
// told from their neighbours. Knows nothing of how the finger bends; the peer to MarkerModel.
#pragma once

#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

namespace alltact {

/// Sorts the dots of each side face (Dot::upper) from base to tip and numbers them in that order.
/// Of more than `per_row` dots in a row those of the largest |contrast| are kept (the paper's
/// detector gives each a score; ours a contrast). Of fewer, the numbers are those whose steps from
/// neighbour to neighbour are most nearly what they were `before` (the markers of the frame before,
/// or at rest). Where that is not known (nullptr), those whose steps are most even, the tip's being
/// taken for hidden where nothing else decides: perspective makes steps uneven too, so that then
/// short rows in which inner markers are hidden may be numbered wrongly.
///
/// Hidden markers lie evenly between the seen ones on both sides, or go on from the last two as
/// these do. Their sd_px is what a straight line leaves out of a curve that bends as the seen ones
/// do: half the second difference times the distances, in numbers, to those two; at least 1 px.
///
/// nullopt where a row shows fewer than two dots (none, of a finger with one a row).
[[nodiscard]] std::optional<Markers> paper_rows(const std::vector<Dot>& dots,
                                                int per_row,
                                                bool base_at_low_u,
                                                const Markers* before = nullptr);

}  // namespace alltact
