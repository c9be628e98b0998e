// Loops over pixels without a scalar remainder.
#pragma once

#include <array>
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

}  // namespace alltact
