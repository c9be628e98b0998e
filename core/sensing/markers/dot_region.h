// Connected pixels above the surroundings of a dot.
#pragma once

#include "core/sensing/markers/dot_window.h"

namespace alltact::dots {

/// Centre and second moments in the window's pixels, and the type of its boundary.
struct Region {
  int area = 0;
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  double sum = 0;  // of heights above the level
  bool at_window_edge = false, at_border = false, at_face = false;
};
/// The pixels connected to (x, y) that are higher than `height` above the surrounding level.
Region grow(const Window& w, double level, int x, int y, double height, const cv::Size& image_size);

/// True for the area of a uniform ellipse, 4 pi sqrt(det covariance); ragged regions have less.
bool is_compact(const Region& region);

/// The uniform ellipse with the region's moments.
Ellipse ellipse_of(const Region& region);

}  // namespace alltact::dots
