// Where in the picture the board was seen and how it was tilted, and what views are missing.
#pragma once

#include "calibration/lens/lens_fit.h"
#include "core/message.h"

#include <vector>

namespace alltact {

/// The angle between the board's normal and the line of sight to its middle, and where to the
/// normal that looks at the camera leans: x to the right, y down; length the angle, degrees.
[[nodiscard]] Eigen::Vector2d tilt_deg(const BoardView& view, const BoardPose& pose);

struct LensCoverage {
  double seen_part = 0;           ///< of 6 x 4 cells of the picture, those where a corner was seen
  std::vector<Message> unseen;    ///< thirds of the picture ("right edge", "top left corner")
  int tilted_views = 0;           ///< by 15 degrees or more
  std::vector<Message> untilted;  ///< ways in which no view is tilted ("to the left", "up")
  bool enough =
      false;       ///< ten views, four of them tilted in three ways, no edge nor the middle unseen
  Message advice;  ///< "three more, tilted to the left, near the right edge"; empty: no more
};

/// Views needed before a lens is called well covered.
inline constexpr int kEnoughViews = 10;

/// Corners that the fit left out do not count.
[[nodiscard]] LensCoverage coverage_of(const std::vector<BoardView>& views, const LensFit& fit);

}  // namespace alltact
