// Background of a dot: level, slope and noise.
#pragma once

#include "core/sensing/markers/dot_window.h"

namespace alltact::dots {

struct Background {
  double level = 0, slope_x = 0, slope_y = 0;  // at the origin of the window's coordinates (x, y)
  double noise = 0;

  [[nodiscard]] double at(double x, double y) const { return level + slope_x * x + slope_y * y; }
};
/// Coarse level and noise around an ellipse grown in x and y: enough to detect a dot. nullopt: too
/// few pixels are usable.
std::optional<Background> level_around(const Window& w,
                                       const Ellipse& inner,
                                       double grow_x,
                                       double grow_y);

/// Plane through the pixels around the ellipse that are within `spread` of their median. Only
/// pixels of the ring count, so that a second dot or the side face's far edge has no influence
/// unless it fills half of it. nullopt: too few pixels are usable.
std::optional<Background> plane_around(const Window& w,
                                       const Ellipse& inner,
                                       double grow,
                                       double spread);

}  // namespace alltact::dots
