// Colours for figures that even steps look even in, also in grey and to colour-blind eyes.
#pragma once

#include <array>
#include <cstdint>

namespace alltact {

struct MapColour {
  std::uint8_t red, green, blue;
};

/// Of 0 to 1 (viridis); part is clamped.
[[nodiscard]] MapColour viridis(double part);

/// Of -1 (blue) through 0 (light grey) to 1 (red), for differences (Moreland's cool to warm);
/// clamped.
[[nodiscard]] MapColour cool_to_warm(double part);

/// How far the colours of bulges reach, in parts of those of presses: 0.1 mm of bulge shows on the
/// scale of presses of 1.5 mm.
inline constexpr double kBulgePart = 0.25;
/// Of a depth over the top of its scale: viridis from 0 to 1; below 0, where skin bulges, from
/// viridis' dark end through red to light pink at -kBulgePart. Lightness rises both ways, so zero
/// is the darkest; clamped.
[[nodiscard]] MapColour depth_colour(double part);

/// Numbers in colours: `low_mm` and what is below in the first, `top_mm` and above in the last.
struct ColourScale {
  double low_mm = 0, top_mm = 1;
  MapColour (*colour)(double part) = viridis;  ///< of [0, 1]
  int steps = 4;                               ///< between its written numbers
};
/// Depths from -kBulgePart top_mm, as depth_colour(); differences from -top_mm, light grey in the
/// middle.
[[nodiscard]] ColourScale depth_scale(double top_mm);
[[nodiscard]] ColourScale difference_scale(double top_mm);

}  // namespace alltact
