// Form factors in closed form, of J. Howell's "A catalog of radiation heat transfer configuration
// factors", in long double; all lengths in one unit.
#pragma once

#include <cmath>
#include <numbers>

namespace alltact {

/// B-3: a rectangle a x b opposite a small area at distance c, one of its corners over it.
inline long double howell_b3(long double a, long double b, long double c) {
  const long double x = a / c, y = b / c, w = std::sqrt(1 + x * x), h = std::sqrt(1 + y * y);
  return (x / w * std::atan(y / w) + y / h * std::atan(x / h)) /
         (2 * std::numbers::pi_v<long double>);
}

/// B-4: a rectangle upright to a small area and standing on its plane, one corner `away` from it.
inline long double howell_b4(long double height, long double width, long double away) {
  const long double x = height / width, y = away / width, r = std::sqrt(x * x + y * y);
  return (std::atan(1 / y) - y / r * std::atan(1 / r)) / (2 * std::numbers::pi_v<long double>);
}

/// C-14: from a rectangle a x b to one of c x b at a right angle, with the edge b in common.
inline long double howell_c14(long double a, long double b, long double c) {
  const long double h = c / b, w = a / b, h2 = h * h, w2 = w * w, r = std::sqrt(h2 + w2);
  const long double logs = std::log((1 + w2) * (1 + h2) / (1 + w2 + h2)) +
                           w2 * std::log(w2 * (1 + w2 + h2) / ((1 + w2) * (w2 + h2))) +
                           h2 * std::log(h2 * (1 + h2 + w2) / ((1 + h2) * (h2 + w2)));
  return (w * std::atan(1 / w) + h * std::atan(1 / h) - r * std::atan(1 / r) + logs / 4) /
         (std::numbers::pi_v<long double> * w);
}

}  // namespace alltact
