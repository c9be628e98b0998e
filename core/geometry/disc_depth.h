// How deep a ball is pressed in, told by the dark disc that it leaves, before any mapping is known.
#pragma once

#include <algorithm>

namespace alltact {

/// Of the darkest part: where the border of the dark disc is drawn.
inline constexpr double kDiscLevel = 0.4;

/// Where a cap of height h is kDiscLevel h deep it has the radius r with r^2 = 2 R h (1 -
/// kDiscLevel), R the ball's radius and h small against it. At most 0.9 R. Both radii > 0, mm.
[[nodiscard]] inline double disc_depth_mm(double disc_radius_mm, double ball_radius_mm) {
  return std::min(0.9 * ball_radius_mm,
                  disc_radius_mm * disc_radius_mm / (2.0 * (1.0 - kDiscLevel) * ball_radius_mm));
}

}  // namespace alltact
