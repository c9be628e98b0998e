// The connected pixels that stand out of a dot's surroundings.
#pragma once

#include "core/sensing/markers/dot_window.h"

namespace alltact::dots {

/// Place and second moments in the window's pixels, and what bounds it.
struct Region {
  int area = 0;
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  double sum = 0;  // of heights
  bool at_window_edge = false, at_border = false, at_face = false;
};
/// The pixels connected to (x, y) that stand higher than `height` above the level around them.
Region grow(const Window& w, double level, int x, int y, double height, const cv::Size& picture);

/// A uniform ellipse has area 4 pi sqrt(det covariance); anything ragged has less.
bool is_compact(const Region& region);

/// The uniform ellipse with the region's moments.
Ellipse ellipse_of(const Region& region);

}  // namespace alltact::dots
