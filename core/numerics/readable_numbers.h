// Text of a standard deviation, never written as 0.
#pragma once

#include <cmath>
#include <string>

namespace alltact {

/// Kind of an sd written next to a value with this many decimals. One that would round to 0 is
/// "under" the last digit; one that is 0, negative or not finite was not estimated.
enum class SdKind { kNumber, kUnder, kUnknown };
[[nodiscard]] inline SdKind sd_kind(double sd, int decimals) {
  if (!(sd > 0) || !std::isfinite(sd)) return SdKind::kUnknown;
  return sd < 0.5 * std::pow(10, -decimals) ? SdKind::kUnder : SdKind::kNumber;
}

/// In English: "1.234 +- 0.054", "1.234 +- under 0.001", "1.234 +- unknown".
[[nodiscard]] std::string value_and_sd(double value, double sd, int decimals);

// Round numbers for scales.

/// The smallest of 1, 2 and 5 times a power of ten that is not below `span` (> 0): steps of an
/// axis, or a scale that does not jump with every reading.
[[nodiscard]] inline double round_step(double span) {
  const double decade = std::pow(10.0, std::floor(std::log10(span)));
  for (const double step : {1.0, 2.0, 5.0})
    if (span <= step * decade) return step * decade;
  return 10.0 * decade;
}

}  // namespace alltact
