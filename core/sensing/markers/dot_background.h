// What surrounds a dot: its level, slope and noise.
#pragma once

#include "core/sensing/markers/dot_window.h"

namespace alltact::dots {

struct Background {
  double level = 0, slope_x = 0, slope_y = 0;  // at window centre of coordinates (x, y)
  double noise = 0;

  [[nodiscard]] double at(double x, double y) const { return level + slope_x * x + slope_y * y; }
};
/// Level of the surroundings of an ellipse grown in x and y, and their noise, coarsely: enough to
/// tell whether there is a dot. nullopt: too little is seen of them.
std::optional<Background> level_around(const Window& w,
                                       const Ellipse& inner,
                                       double grow_x,
                                       double grow_y);

/// Plane through the pixels around the ellipse that lie within `spread` of their median. Only
/// pixels of the ring count, so that a second dot or the side face's far edge has no say unless it
/// fills half of it. nullopt: too little is seen of them.
std::optional<Background> plane_around(const Window& w,
                                       const Ellipse& inner,
                                       double grow,
                                       double spread);

}  // namespace alltact::dots
