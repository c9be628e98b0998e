// Loops over pixels without a scalar remainder.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace alltact {

constexpr int kBlock = 64;  ///< numbers at a time: the widest vector of bytes

/// Calls body(first, count) for blocks of kBlock that cover 0 to n. The last block overlaps the
/// previous one: processing an element twice must give the same result. `count` is a compile-time
/// number but for n < kBlock. A scalar remainder would take as long as all vectors. The body must
/// be marked always_inline, or it would not be built for the caller's processor.
template <class Body>
[[gnu::always_inline]] inline void in_blocks(int n, Body body) {
  if (n < kBlock) {
    body(0, n);
    return;
  }
  constexpr std::integral_constant<int, kBlock> kFull;
  int first = 0;
  for (; first + kBlock <= n; first += kBlock) body(first, kFull);
  if (first < n) body(n - kBlock, kFull);
}

/// Maximum and minimum of a block's accumulators, vectorised.
template <class Number>
[[gnu::always_inline]] inline Number max_of(const std::array<Number, kBlock>& numbers) {
  Number max_value = numbers[0];
  for (const Number number : numbers) max_value = number > max_value ? number : max_value;
  return max_value;
}
template <class Number>
[[gnu::always_inline]] inline Number min_of(const std::array<Number, kBlock>& numbers) {
  Number min_value = numbers[0];
  for (const Number number : numbers) min_value = number < min_value ? number : min_value;
  return min_value;
}

// Functions of one number for loops over a row. Without branches and tables the compiler vectorises
// them, unlike those of <cmath>. The bytes are the same on every processor.

/// exp(x), within 2e-7 of it relatively; x is clamped to -87 .. 88. After Cephes' expf (S. L.
/// Moshier, netlib).
[[nodiscard]] inline float vector_exp(float x) {
  x = std::min(std::max(x, -87.0F), 88.0F);
  const int n = static_cast<int>(x * 1.44269504F + 128.5F) - 128;  // nearest power of 2
  const auto rounded = static_cast<float>(n);
  const float r = x - rounded * 0.693359375F + rounded * 2.12194440e-4F;
  float p = 1.9875691500e-4F;
  p = p * r + 1.3981999507e-3F;
  p = p * r + 8.3334519073e-3F;
  p = p * r + 4.1665795894e-2F;
  p = p * r + 1.6666665459e-1F;
  p = p * r + 5.0000001201e-1F;
  return (p * r * r + r + 1.0F) * std::bit_cast<float>((n + 127) << 23);
}

/// The natural logarithm of a normal number above 0, within 1e-7 of it or of 1. After Cephes' logf.
[[nodiscard]] inline float vector_log(float x) {
  constexpr std::int32_t kRootOfHalf = 0x3f3504f3;
  const std::int32_t bits = std::bit_cast<std::int32_t>(x) - kRootOfHalf;
  const auto power = static_cast<float>(bits >> 23);
  const float f = std::bit_cast<float>((bits & 0x7fffff) + kRootOfHalf) - 1.0F;
  float p = 7.0376836292e-2F;
  p = p * f - 1.1514610310e-1F;
  p = p * f + 1.1676998740e-1F;
  p = p * f - 1.2420140846e-1F;
  p = p * f + 1.4249322787e-1F;
  p = p * f - 1.6668057665e-1F;
  p = p * f + 2.0000714765e-1F;
  p = p * f - 2.4999993993e-1F;
  p = p * f + 3.3333331174e-1F;
  const float f2 = f * f;
  return f + (f * f2 * p - 2.12194440e-4F * power - 0.5F * f2) + 0.693359375F * power;
}

/// x^power, 0 for x <= 0; within 2e-7 of it relatively for every unit of |power log x|.
[[nodiscard]] inline float vector_pow(float x, float power) {
  const float result = vector_exp(power * vector_log(std::max(x, 1e-30F)));
  return x > 1e-30F ? result : 0.0F;
}

/// cos of so many turns, |turns| < 1e4; within 1e-6 of it, plus the rounding of `turns`.
[[nodiscard]] inline float vector_cos_turns(float turns) {
  const float t = turns - static_cast<float>(static_cast<int>(turns + 16384.5F) - 16384);
  // cos(2 pi t) = sin(2 pi (1/4 - |t|)), with the sine's series about 0 up to a quarter turn.
  const float a = 6.28318531F * (0.25F - (t < 0 ? -t : t)), a2 = a * a;
  float p = -2.5052108e-8F;
  p = p * a2 + 2.7557319e-6F;
  p = p * a2 - 1.9841270e-4F;
  p = p * a2 + 8.3333333e-3F;
  p = p * a2 - 1.6666667e-1F;
  return a + a * a2 * p;
}

}  // namespace alltact
