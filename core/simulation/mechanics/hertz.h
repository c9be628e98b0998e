// Deflection of a soft half space around an indenting ball (Hertz).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alltact {

/// Deflection of the surface relative to that under the ball's centre, at q = a/r in (0, 1], a the
/// radius of contact: ((2 - r^2/a^2) asin(a/r) + sqrt(r^2/a^2 - 1)) / pi, 0.5 at the rim. Far out
/// this is a difference of large numbers, so its series is used instead.
[[nodiscard]] inline double hertz_tail(double q) {
  if (q < 0.05) {
    const double q2 = q * q;
    return q * (4.0 / 3 + q2 * (2.0 / 15 + q2 * (3.0 / 70 + q2 * 5.0 / 252))) / std::numbers::pi;
  }
  const double r = 1 / q;
  return ((2 - r * r) * std::asin(q) + std::sqrt(std::max(0.0, r * r - 1))) / std::numbers::pi;
}

}  // namespace alltact
