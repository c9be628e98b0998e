// The measurable range of grey levels: one definition of clipped and of too dark for all modules.
#pragma once

#include <algorithm>

namespace alltact {

/// Grey levels (0 to 255) from this one on are clipped: their true brightness is unknown. This
/// holds for live and reference images. Cameras clip a few levels below 255 as well.
constexpr int kClippedFrom = 250;

/// A reference below this grey level is too dark to divide by, however low its noise is. A live
/// image has no lower limit, because presses darken it.
constexpr int kTooDarkBelow = 8;

/// The same limit for an image with known noise (standard deviation, grey levels). A reference must
/// exceed its noise six times, or quotients are biased.
[[nodiscard]] constexpr double too_dark_below(double noise_sd) {
  constexpr double kNoiseSds = 6.0;
  return std::clamp<double>(kNoiseSds * noise_sd, kTooDarkBelow, kClippedFrom);
}

/// Bits that an image uses of up to 16, by its brightest value: as few of `at_least`, two more, ...
/// as hold it. at_least: 8 or 10.
[[nodiscard]] constexpr int bits_in_use(int brightest, int at_least) {
  int bits = at_least;
  while (brightest >= 1 << bits) bits += 2;
  return bits;
}

/// An image is coloured where the mean distance of its channels from grey exceeds this part of its
/// mean grey.
constexpr double kMaxColour = 0.12;

}  // namespace alltact
