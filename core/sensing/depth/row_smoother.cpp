#include "core/sensing/depth/row_smoother.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

namespace alltact {
namespace {

constexpr int kMostPairs = 6;  // at a time: as many vectors as can be held

/// Pixels and their neighbours before and behind them, at some distances.
struct Neighbours {
  const std::int16_t* middle;  // nullptr: what has been added up so far
  std::int16_t own;            // weight of the middle
  std::array<const std::int16_t*, kMostPairs> before, behind;
  std::array<std::int16_t, kMostPairs> weights;
};

/// out = the middle and its neighbours weighed and added in one pass. What is smoothed is such that
/// a pair's sum fits; all sums may wrap around on the way. Gives the largest where that is wanted,
/// at least 0.
template <bool kLargest, std::size_t... kPair>
[[gnu::always_inline]] inline std::int16_t weigh_pairs(const Neighbours& given,
                                                       int count,
                                                       std::int16_t* __restrict out,
                                                       std::index_sequence<kPair...>) {
  const Neighbours near = given;
  const auto pairs_at = [&](int i) __attribute__((always_inline)) {
    return (... + times(static_cast<std::int16_t>(near.before[kPair][i] + near.behind[kPair][i]),
                        near.weights[kPair]));
  };
  if (near.middle == nullptr) {
    std::int16_t largest = 0;
    for (int i = 0; i < count; ++i) {
      out[i] = static_cast<std::int16_t>(out[i] + pairs_at(i));
      largest = out[i] > largest ? out[i] : largest;
    }
    return largest;
  }
  // By place in a block: brought together once, not in every block.
  std::array<std::int16_t, kBlock> most{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        for (int k = 0; k < size; ++k) {
          const int i = first + k;
          const auto sum = static_cast<std::int16_t>(times(near.middle[i], near.own) + pairs_at(i));
          out[i] = sum;
          std::int16_t& here = most[static_cast<std::size_t>(k)];
          if constexpr (kLargest) here = sum > here ? sum : here;
        }
      });
  return kLargest ? largest_of(most) : std::int16_t{0};
}

template <bool kLargest>
[[gnu::always_inline]] inline std::int16_t weigh_count(const Neighbours& near,
                                                       int pairs,
                                                       int count,
                                                       std::int16_t* out) {
  switch (pairs) {
    case 2:
      return weigh_pairs<kLargest>(near, count, out, std::make_index_sequence<2>());
    case 4:
      return weigh_pairs<kLargest>(near, count, out, std::make_index_sequence<4>());
    default:
      return weigh_pairs<kLargest>(near, count, out, std::make_index_sequence<kMostPairs>());
  }
}

ALLTACT_WIDE std::int16_t weigh_columns(const Neighbours& near,
                                        int pairs,
                                        int count,
                                        std::int16_t* out) {
  return weigh_count<true>(near, pairs, count, out);
}
ALLTACT_WIDE std::int16_t weigh_row(const Neighbours& near,
                                    int pairs,
                                    int count,
                                    std::int16_t* out) {
  return weigh_count<false>(near, pairs, count, out);
}

/// A kernel's weights, of 2^-15, of the middle and of an even number of distances from it. Outer
/// ones are whole 2^-9: of whole grey levels the products then lose little, and dark faces, which
/// have few steps, do not drift by what is rounded away alike in every pixel.
std::vector<std::int16_t> whole_weights(const Smoothing& smoothing) {
  constexpr double kCoarse = 512;
  constexpr long kFine = 32768 / 512;
  std::vector<std::int16_t> result{0};
  long middle = 32768;
  for (std::size_t k = 1; k < smoothing.weights.size(); ++k) {
    const long weight = kFine * std::lround(kCoarse * smoothing.weights[k]);
    result.push_back(static_cast<std::int16_t>(weight));
    middle -= 2 * weight;
  }
  result.front() = static_cast<std::int16_t>(std::min(32767L, middle));
  while (result.size() < 3 || result.size() % 2 == 0) result.push_back(0);
  return result;
}

/// The outer weights are negative: where those pixels are missing, a column's sum may be more than
/// the brightest pixel, and that of a pair would not fit: above this.
constexpr std::int16_t kMostOfPair = INT16_MAX / 2;

ALLTACT_WIDE void halve(std::int16_t* sums, int count) {
  for (int i = 0; i < count; ++i) sums[i] = static_cast<std::int16_t>((sums[i] + 1) >> 1);
}
ALLTACT_WIDE void twice(std::int16_t* smooth, int count) {
  for (int i = 0; i < count; ++i) smooth[i] = static_cast<std::int16_t>(2 * smooth[i]);
}

/// neighbours(k): the pixels k before and k behind the first of `middle`. Gives what `some` gives.
template <class Some, class At>
std::int16_t weigh(const std::vector<std::int16_t>& weights,
                   const std::int16_t* middle,
                   int count,
                   std::int16_t* out,
                   Some some,
                   At neighbours) {
  const int radius = static_cast<int>(weights.size()) - 1;
  std::int16_t largest = 0;
  for (int done = 0; done < radius; done += kMostPairs) {
    Neighbours near{done == 0 ? middle : nullptr, weights.front(), {}, {}, {}};
    const int pairs = std::min(kMostPairs, radius - done);
    for (int k = 0; k < pairs; ++k) {
      const auto i = static_cast<std::size_t>(k);
      std::tie(near.before[i], near.behind[i]) = neighbours(done + k + 1);
      near.weights[i] = weights[static_cast<std::size_t>(done + k + 1)];
    }
    largest = some(near, pairs, count, out);
  }
  return largest;
}

}  // namespace

RowSmoother::RowSmoother(const Smoothing& smoothing, int width)
    : weights_(whole_weights(smoothing)),
      radius_(static_cast<int>(weights_.size()) - 1),
      width_(width),
      step_(width + 2 * radius_),
      slots_(std::bit_ceil(static_cast<std::size_t>(2 * radius_ + 1))),
      rows_(slots_ * static_cast<std::size_t>(step_), 0),
      filled_(slots_),
      sums_(static_cast<std::size_t>(step_), 0),
      smooth_(static_cast<std::size_t>(width)) {}

std::int16_t* RowSmoother::fresh_row(int number, std::span<const FaceRun> runs) {
  std::vector<FaceRun>& old = filled_[slot(number)];
  std::int16_t* begin = line(number);
  const auto clear = [&](int first, int end) {
    if (first < end) std::fill(begin + first, begin + end, std::int16_t{0});
  };
  for (const FaceRun& was : old) {
    int from = was.first;
    for (const FaceRun& run : runs) {
      clear(from, std::min(was.end, run.first));
      from = std::max(from, run.end);
    }
    clear(from, was.end);
  }
  old.assign(runs.begin(), runs.end());
  return begin;
}

const std::int16_t* RowSmoother::smoothed(int number, const FaceRun& run) {
  const int from = std::max(run.first - radius_, 0), to = std::min(run.end + radius_, width_);
  std::int16_t* sums = sums_.data() + radius_;
  // Beyond the picture there is nothing.
  std::fill(sums + run.first - radius_, sums + from, std::int16_t{0});
  std::fill(sums + to, sums + run.end + radius_, std::int16_t{0});
  const std::int16_t largest =
      weigh(weights_, line(number) + from, to - from, sums + from, weigh_columns, [&](int k) {
        return std::pair(line(number - k) + from, line(number + k) + from);
      });
  const bool fits = largest <= kMostOfPair;
  if (!fits) halve(sums + from, to - from);
  std::int16_t* smooth = smooth_.data() + run.first;
  weigh(weights_, sums + run.first, run.size(), smooth, weigh_row, [&](int k) {
    return std::pair(sums + run.first - k, sums + run.first + k);
  });
  if (!fits) twice(smooth, run.size());
  return smooth;
}

}  // namespace alltact
