// Which of many dots are the row of markers: the ones that lie evenly and look alike.
#pragma once

#include "core/sensing/markers.h"

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

/// The most even choice, judged in millimetres along the finger rather than in pixels, of `per_row`
/// dots of one side, in the order of u from base to tip, by dynamic programming over pairs of
/// neighbours. nullopt where there are fewer dots than that.
[[nodiscard]] std::optional<DotRow> choose_row(const std::vector<Dot>& dots,
                                               bool upper,
                                               int per_row,
                                               bool base_at_low_u);

}  // namespace alltact
