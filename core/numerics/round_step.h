// Round numbers for scales.
#pragma once

#include <cmath>

namespace alltact {

/// The smallest of 1, 2 and 5 times a power of ten that is not below `span` (> 0): steps of an
/// axis, or a scale that does not jump with every reading.
[[nodiscard]] inline double round_step(double span) {
  const double decade = std::pow(10.0, std::floor(std::log10(span)));
  for (const double step : {1.0, 2.0, 5.0})
    if (span <= step * decade) return step * decade;
  return 10.0 * decade;
}

}  // namespace alltact
