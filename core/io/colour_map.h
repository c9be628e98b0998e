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

/// Numbers in colours: `low_mm` and what is below in the first, `top_mm` and above in the last.
struct ColourScale {
  double low_mm = 0, top_mm = 1;
  MapColour (*colour)(double part) = viridis;  ///< of [0, 1]
  int steps = 4;                               ///< between its written numbers
};
/// Depths from 0; differences from -top_mm, light grey in the middle.
[[nodiscard]] ColourScale depth_scale(double top_mm);
[[nodiscard]] ColourScale difference_scale(double top_mm);

}  // namespace alltact
