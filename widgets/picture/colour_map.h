// Viridis: even steps look even, also in grey and to colour-blind eyes.
#pragma once

#include <array>
#include <cstdint>

namespace alltact {

struct MapColour {
  std::uint8_t red, green, blue;
};

/// part in [0, 1], clamped.
[[nodiscard]] MapColour viridis(double part);

}  // namespace alltact
