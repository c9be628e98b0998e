// Loops over pixels without a rest that runs one by one.
#pragma once

#include <array>
#include <type_traits>

namespace alltact {

constexpr int kBlock = 64;  ///< numbers at a time: the widest vector of bytes

/// Calls body(first, count) for blocks of kBlock that cover 0 to n, the last of which overlaps the
/// one before: doing a place twice must give the same as once. `count` is a compile-time number
/// but for n < kBlock. What does not fill a vector otherwise takes as long as all that does. The
/// body must be marked always_inline, or it would not be built for the caller's processor.
template <class Body>
[[gnu::always_inline]] inline void in_blocks(int n, Body body) {
  if (n < kBlock) {
    body(0, n);
    return;
  }
  constexpr std::integral_constant<int, kBlock> kWhole;
  int first = 0;
  for (; first + kBlock <= n; first += kBlock) body(first, kWhole);
  if (first < n) body(n - kBlock, kWhole);
}

/// The largest and the least of what a loop gathered by place in a block, in vectors.
template <class Number>
[[gnu::always_inline]] inline Number largest_of(const std::array<Number, kBlock>& numbers) {
  Number largest = numbers[0];
  for (const Number number : numbers) largest = number > largest ? number : largest;
  return largest;
}
template <class Number>
[[gnu::always_inline]] inline Number least_of(const std::array<Number, kBlock>& numbers) {
  Number least = numbers[0];
  for (const Number number : numbers) least = number < least ? number : least;
  return least;
}

}  // namespace alltact
