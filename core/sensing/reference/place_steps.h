// Places of many pixels side by side, in whole steps of a fixed-point picture place.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace alltact {

constexpr int kPlaceBits = 11;  ///< of a place's fraction: 1/2048 px

/// What lies side by side in one picture nearly does so in the other. So the places of a piece are
/// but a few steps apart: instead of fetching each from its own place, whole pieces are read at
/// each of these steps, and every place keeps what it finds at its own.
template <std::size_t kPlaces>
struct PlaceSteps {
  alignas(64) std::array<std::int16_t, kPlaces> steps, part;  ///< from `least` on; of 2^15
  int least, most;                                            ///< whole steps
};

/// `fixed`: places of 2^-kPlaceBits px, each less what the picture itself advances by; what
/// is left in it means nothing.
template <std::size_t kPlaces>
[[gnu::always_inline]] inline void find_steps(std::array<int, kPlaces>& fixed,
                                              PlaceSteps<kPlaces>& piece) {
  constexpr int kFraction = (1 << kPlaceBits) - 1;
  int least = fixed[0], most = fixed[0];
  for (const int place : fixed) {
    least = place < least ? place : least;
    most = place > most ? place : most;
  }
  piece.least = least >> kPlaceBits;
  piece.most = most >> kPlaceBits;
  const int base = piece.least * (1 << kPlaceBits);
  for (std::size_t k = 0; k < kPlaces; ++k) fixed[k] -= base;
  for (std::size_t k = 0; k < kPlaces; ++k)
    piece.steps[k] = static_cast<std::int16_t>(fixed[k] >> kPlaceBits);
  for (std::size_t k = 0; k < kPlaces; ++k)
    piece.part[k] = static_cast<std::int16_t>((fixed[k] & kFraction) << (15 - kPlaceBits));
}

}  // namespace alltact
