// Interpolation between the nodes of a curve.
#pragma once

namespace alltact {

/// Cubic Hermite interpolation on a cell of width h, t in [0, 1]: values f and derivatives d at its
/// ends.
inline double hermite(double f0, double d0, double f1, double d1, double h, double t) {
  const double u = 1 - t;
  return u * u * (f0 * (1 + 2 * t) + h * d0 * t) + t * t * (f1 * (3 - 2 * t) - h * d1 * u);
}

/// Cosine and sine of an angle `by` beyond one with known cosine and sine, |by| <= kSeriesTurn: the
/// series, within 3e-17, and the addition theorems.
inline constexpr double kSeriesTurn = 0.1;
struct TurnedDirection {
  double cos, sin;
};
inline TurnedDirection turned(double cos, double sin, double by) {
  const double by2 = by * by;
  const double s =
      by - by * by2 * (1.0 / 6 - by2 * (1.0 / 120 - by2 * (1.0 / 5040 - by2 / 362880)));
  const double c = by2 * (1.0 / 2 - by2 * (1.0 / 24 - by2 * (1.0 / 720 - by2 / 40320)));  // 1 - cos
  return {cos - (cos * c + sin * s), sin - (sin * c - cos * s)};
}

}  // namespace alltact
