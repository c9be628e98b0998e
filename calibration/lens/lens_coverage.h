// Coverage of the image and of tilts by the views, and missing views.
#pragma once

#include "calibration/lens/lens_fit.h"
#include "core/message.h"

#include <vector>

namespace alltact {

/// The tilt of the board's normal against the line of sight to its middle. The vector gives the
/// direction in which the normal towards the camera leans: x to the right, y down; its length is
/// the angle, degrees.
[[nodiscard]] Eigen::Vector2d tilt_deg(const BoardView& view, const BoardPose& pose);

struct LensCoverage {
  double seen_part = 0;           ///< of 6 x 4 cells of the image, those with a corner
  std::vector<Message> unseen;    ///< thirds of the image ("right edge", "top left corner")
  int tilted_views = 0;           ///< by 15 degrees or more
  std::vector<Message> untilted;  ///< directions in which no view is tilted ("to the left", "up")
  bool enough =
      false;  ///< ten views, four of them tilted in three directions, no edge nor the middle unseen
  Message advice;  ///< "three more, tilted to the left, near the right edge"; empty: none needed
};

/// Views needed for full coverage.
inline constexpr int kEnoughViews = 10;

/// Corners that the fit left out do not count.
[[nodiscard]] LensCoverage coverage_of(const std::vector<BoardView>& views, const LensFit& fit);

}  // namespace alltact
