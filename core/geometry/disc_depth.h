// Indentation depth of a ball, estimated from its dark disc before any mapping is known.
#pragma once

#include <algorithm>

namespace alltact {

/// Fraction of the depth: the level at which the border of the dark disc is drawn.
inline constexpr double kDiscLevel = 0.4;

/// A cap of height h has depth kDiscLevel h at the radius r with r^2 = 2 R h (1 - kDiscLevel), R
/// the ball's radius and h small against it. At most 0.9 R. Both radii > 0, mm.
[[nodiscard]] inline double disc_depth_mm(double disc_radius_mm, double ball_radius_mm) {
  return std::min(0.9 * ball_radius_mm,
                  disc_radius_mm * disc_radius_mm / (2.0 * (1.0 - kDiscLevel) * ball_radius_mm));
}

}  // namespace alltact
