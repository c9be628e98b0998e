// Perceptually uniform colour maps for figures, also in grey and for colour-blind people.
#pragma once

#include <array>
#include <cstdint>

namespace alltact {

struct MapColour {
  std::uint8_t red, green, blue;
};

/// viridis on 0 to 1; `part` is clamped.
[[nodiscard]] MapColour viridis(double part);

/// Diverging map on -1 (blue), 0 (light grey) and 1 (red), for differences (Moreland's cool to
/// warm); clamped.
[[nodiscard]] MapColour cool_to_warm(double part);

/// Range of the colours for bulges, relative to that for presses: 0.1 mm of bulge shows on a scale
/// for presses of 1.5 mm.
inline constexpr double kBulgeFraction = 0.25;
/// Map for depth relative to the top of its scale. Untouched skin, 0, is neutral grey. Above it are
/// blue, green and yellow, the upper three quarters of viridis. Below it, where skin bulges, are
/// red and light pink down to -kBulgeFraction. Lightness rises in both directions, so zero is the
/// darkest; clamped.
[[nodiscard]] MapColour depth_colour(double part);

/// A colour scale: the first colour for `low_mm` and less, the last for `top_mm` and more.
struct ColourScale {
  double low_mm = 0, top_mm = 1;
  MapColour (*colour)(double part) = viridis;  ///< on [0, 1]
  int steps = 4;                               ///< number of intervals between labels

  /// Decimals, at least 2, that write each of so many evenly spaced labels as it is; at most 5.
  [[nodiscard]] int label_decimals(int labels) const;
};
/// The depth scale begins at -kBulgeFraction top_mm, as depth_colour(). The difference scale begins
/// at -top_mm, with light grey in the middle.
[[nodiscard]] ColourScale depth_scale(double top_mm);
[[nodiscard]] ColourScale difference_scale(double top_mm);

}  // namespace alltact
