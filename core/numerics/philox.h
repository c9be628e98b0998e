// Philox4x32-10 (Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", SC 2011): random
// bits as a pure function of a counter and a key. No state, so no order of calls can matter.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace alltact {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

inline constexpr std::uint32_t kPhiloxMultiplier0 = 0xD2511F53U;
inline constexpr std::uint32_t kPhiloxMultiplier1 = 0xCD9E8D57U;
inline constexpr std::uint32_t kPhiloxWeyl0 = 0x9E3779B9U;
inline constexpr std::uint32_t kPhiloxWeyl1 = 0xBB67AE85U;
inline constexpr int kPhiloxRounds = 10;

/// 128 random bits.
[[nodiscard]] constexpr PhiloxCounter philox(PhiloxCounter c, PhiloxKey key) {
  for (int round = 0; round < kPhiloxRounds; ++round) {
    const std::uint64_t p0 = std::uint64_t{kPhiloxMultiplier0} * c[0];
    const std::uint64_t p1 = std::uint64_t{kPhiloxMultiplier1} * c[2];
    c = {static_cast<std::uint32_t>(p1 >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(p1),
         static_cast<std::uint32_t>(p0 >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(p0)};
    key = {key[0] + kPhiloxWeyl0, key[1] + kPhiloxWeyl1};
  }
  return c;
}

/// 32-bit FNV-1a: hashes a stream name into half a key.
[[nodiscard]] constexpr std::uint32_t fnv1a(std::string_view text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619U;
  return hash;
}

/// A number in (0, 1) from 53 of 64 bits: never 0, never 1.
[[nodiscard]] constexpr double unit_interval(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = (std::uint64_t{high} << 32 | low) >> 12;
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

/// One number in (0, 1) for (seed, stream, frame, index).
[[nodiscard]] constexpr double philox_uniform(std::uint64_t seed, std::string_view stream,
                                              std::uint32_t frame, std::uint32_t index) {
  const PhiloxCounter bits = philox({index, 0, frame, static_cast<std::uint32_t>(seed >> 32)},
                                    {static_cast<std::uint32_t>(seed), fnv1a(stream)});
  return unit_interval(bits[0], bits[1]);
}

}  // namespace alltact
