// Numbering of dots by the source paper: two rows, each sorted along the image, hidden markers
// estimated from their neighbours. Reference method for MarkerModel, without a model of the
// bending.
#pragma once

#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

namespace alltact {

/// Sorts the dots of each side face (Dot::upper) from base to tip and numbers them in that order.
/// Of more than `per_row` dots in a row those of the largest |contrast| are selected; the paper's
/// detector has scores instead. Of fewer, the numbers are those whose steps between neighbours
/// change least relative to `before` (the markers of the frame before, or at rest). With nullptr
/// the numbers are those with the most even steps. The tip's markers then count as hidden where
/// nothing else decides. Perspective makes steps uneven too, so that rows with hidden inner markers
/// may be numbered wrongly.
///
/// Hidden markers are interpolated evenly between the seen ones on both sides, or extrapolated from
/// the last two. Their sd_px is the deviation of a straight line from a curve with the bending of
/// the seen ones. That is half the second difference times the distances, in numbers, to those two;
/// at least 1 px.
///
/// nullopt where a row shows fewer than two dots (none, of a finger with one a row).
[[nodiscard]] std::optional<Markers> paper_rows(const std::vector<Dot>& dots,
                                                int per_row,
                                                bool base_at_low_u,
                                                const Markers* before = nullptr);

}  // namespace alltact
