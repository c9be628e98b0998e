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

}  // namespace alltact
