// Positions of many adjacent pixels, in steps of a fixed-point image position.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace alltact {

constexpr int kPositionBits = 11;  ///< of a position's fraction: 1/2048 px

/// Adjacent pixels of one image map to nearly adjacent positions in the other, so the positions of
/// a chunk differ by a few steps only. Instead of a gather, full chunks are read at each of these
/// steps, and every position selects the value at its own step.
template <std::size_t kCount>
struct PositionSteps {
  /// from `min_step` on; in units of 2^-15
  alignas(64) std::array<std::int16_t, kCount> steps, part;
  int min_step, max_step;  ///< integer steps
};

/// `fixed`: positions in units of 2^-kPositionBits px, each minus the advance of the read window.
/// Its content is undefined afterwards.
template <std::size_t kCount>
[[gnu::always_inline]] inline void find_steps(std::array<int, kCount>& fixed,
                                              PositionSteps<kCount>& piece) {
  constexpr int kFraction = (1 << kPositionBits) - 1;
  int min_fixed = fixed[0], max_fixed = fixed[0];
  for (const int position : fixed) {
    min_fixed = position < min_fixed ? position : min_fixed;
    max_fixed = position > max_fixed ? position : max_fixed;
  }
  piece.min_step = min_fixed >> kPositionBits;
  piece.max_step = max_fixed >> kPositionBits;
  const int base = piece.min_step * (1 << kPositionBits);
  for (std::size_t k = 0; k < kCount; ++k) fixed[k] -= base;
  for (std::size_t k = 0; k < kCount; ++k)
    piece.steps[k] = static_cast<std::int16_t>(fixed[k] >> kPositionBits);
  for (std::size_t k = 0; k < kCount; ++k)
    piece.part[k] = static_cast<std::int16_t>((fixed[k] & kFraction) << (15 - kPositionBits));
}

}  // namespace alltact
