// The grey levels that can be measured: one definition of clipped and of too dark, for all.
#pragma once

#include <algorithm>

namespace alltact {

/// Grey levels (0 to 255) from here on are clipped, in a live picture as in its reference: how
/// bright it was is not known. Cameras clip a few levels below 255 as well.
constexpr int kClippedFrom = 250;

/// A reference below this grey level is too dark to divide by, however little noise there is. A
/// live picture may be as dark as it likes: what presses darkens.
constexpr int kTooDarkBelow = 8;

/// The same where a picture's noise (its standard deviation, grey levels) is known: a reference
/// must stand out of it by six, or quotients are biased.
[[nodiscard]] constexpr double too_dark_below(double noise_sd) {
  constexpr double kSigmas = 6.0;
  return std::clamp<double>(kSigmas * noise_sd, kTooDarkBelow, kClippedFrom);
}

}  // namespace alltact
