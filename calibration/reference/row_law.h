// Which of the dots on the finger are its two rows of markers, and which number each has.
#pragma once

#include "calibration/reference/dot_tracks.h"

#include <vector>

namespace alltact {

struct NumberedRows {
  std::vector<int> track_of;  ///< by number, an index into the tracks; -1: there is none
  double worth = 0;           ///< of the choice: compares one polarity with the other
};

/// The choice of dots that best follows a law: from one to the next the step along the finger
/// changes by about the same factor (1 where dots are evenly spaced in millimetres, more where they
/// are in the picture), size, contrast and distance from the face change little. Dots may be
/// missing (two in a row at most), and what lies beside the law is left out; both rows follow
/// nearly the same law. A row that is shorter than `per_row` takes the numbers at which its dots
/// lie beside those of the other row; where neither tells, it begins at the base. By dynamic
/// programming over pairs of neighbours.
[[nodiscard]] NumberedRows choose_rows(const std::vector<DotTrack>& tracks, int per_row);

}  // namespace alltact
