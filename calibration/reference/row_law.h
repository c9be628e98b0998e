// Selects the two rows of markers among the dots on the finger, and numbers them.
#pragma once

#include "calibration/reference/dot_tracks.h"

#include <vector>

namespace alltact {

struct NumberedRows {
  std::vector<int> track_of;  ///< by number, an index into the tracks; -1: there is none
  double worth = 0;           ///< score of the choice: compares one polarity with the other
};

/// The dots that best follow a law. The step along the finger changes by about a constant factor
/// from one dot to the next (1 for even spacing in millimetres, more for even spacing in the
/// image). Size, contrast and distance from the face change little. At most two consecutive dots
/// may be missing; outliers are left out; both rows follow nearly the same law. A row shorter than
/// `per_row` takes the numbers of the adjacent dots in the other row, or begins at the base where
/// these do not decide. By dynamic programming over pairs of neighbours.
[[nodiscard]] NumberedRows choose_rows(const std::vector<DotTrack>& tracks, int per_row);

}  // namespace alltact
