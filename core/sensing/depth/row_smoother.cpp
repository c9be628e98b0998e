#include "core/sensing/depth/row_smoother.h"

#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace alltact {
namespace {

/// out = a middle with the pairs of neighbours at the next two distances from it on both sides; and
/// two distances more. What is
/// smoothed is such that a pair's sum fits.
ALLTACT_WIDE void weigh_first(const std::int16_t* __restrict middle,
                              const std::int16_t* const* pairs,
                              const std::int16_t* weights,
                              int count,
                              std::int16_t* __restrict out) {
  const std::int16_t *a = pairs[0], *b = pairs[1], *c = pairs[2], *d = pairs[3];
  const std::int16_t w0 = weights[0], w1 = weights[1], w2 = weights[2];
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        for (int i = first; i < first + size; ++i)
          out[i] = static_cast<std::int16_t>(times(middle[i], w0) +
                                             times(static_cast<std::int16_t>(a[i] + b[i]), w1) +
                                             times(static_cast<std::int16_t>(c[i] + d[i]), w2));
      });
}
ALLTACT_WIDE void weigh_more(const std::int16_t* const* pairs,
                             const std::int16_t* weights,
                             int count,
                             std::int16_t* __restrict out) {
  const std::int16_t *a = pairs[0], *b = pairs[1], *c = pairs[2], *d = pairs[3];
  const std::int16_t w1 = weights[0], w2 = weights[1];
  for (int i = 0; i < count; ++i)
    out[i] = static_cast<std::int16_t>(out[i] + times(static_cast<std::int16_t>(a[i] + b[i]), w1) +
                                       times(static_cast<std::int16_t>(c[i] + d[i]), w2));
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
/// the brightest pixel, and that of a pair would not fit. True when all do.
ALLTACT_WIDE bool pairs_fit(const std::int16_t* sums, int count) {
  constexpr std::int16_t kMost = INT16_MAX / 2;
  std::int16_t largest = 0;
  for (int i = 0; i < count; ++i) largest = sums[i] > largest ? sums[i] : largest;
  return largest <= kMost;
}
ALLTACT_WIDE void halve(std::int16_t* sums, int count) {
  for (int i = 0; i < count; ++i) sums[i] = static_cast<std::int16_t>((sums[i] + 1) >> 1);
}
ALLTACT_WIDE void twice(std::int16_t* smooth, int count) {
  for (int i = 0; i < count; ++i) smooth[i] = static_cast<std::int16_t>(2 * smooth[i]);
}

/// neighbours(k): the pixels k before and k behind the first of `middle`.
template <class Neighbours>
void weigh(const std::vector<std::int16_t>& weights,
           const std::int16_t* middle,
           int count,
           std::int16_t* out,
           Neighbours neighbours) {
  for (int k = 1; k + 1 < static_cast<int>(weights.size()); k += 2) {
    const auto [a, b] = neighbours(k);
    const auto [c, d] = neighbours(k + 1);
    const std::array<const std::int16_t*, 4> pairs{a, b, c, d};
    if (k == 1)
      weigh_first(middle, pairs.data(), weights.data(), count, out);
    else
      weigh_more(pairs.data(), weights.data() + k, count, out);
  }
}

}  // namespace

RowSmoother::RowSmoother(const Smoothing& smoothing, int width)
    : weights_(whole_weights(smoothing)),
      radius_(static_cast<int>(weights_.size()) - 1),
      width_(width),
      step_(width + 2 * radius_),
      rows_(static_cast<std::size_t>((2 * radius_ + 1) * step_), 0),
      filled_(static_cast<std::size_t>(2 * radius_ + 1)),
      sums_(static_cast<std::size_t>(step_), 0),
      smooth_(static_cast<std::size_t>(width)) {}

std::int16_t* RowSmoother::fresh_row(int number, std::span<const FaceRun> runs) {
  std::vector<FaceRun>& old = filled_[slot(number)];
  std::int16_t* begin = line(number);
  for (const FaceRun& run : old) std::fill(begin + run.first, begin + run.end, std::int16_t{0});
  old.assign(runs.begin(), runs.end());
  return begin;
}

const std::int16_t* RowSmoother::smoothed(int number, const FaceRun& run) {
  const int from = std::max(run.first - radius_, 0), to = std::min(run.end + radius_, width_);
  std::int16_t* sums = sums_.data() + radius_;
  // Beyond the picture there is nothing.
  std::fill(sums + run.first - radius_, sums + from, std::int16_t{0});
  std::fill(sums + to, sums + run.end + radius_, std::int16_t{0});
  weigh(weights_, line(number) + from, to - from, sums + from, [&](int k) {
    return std::pair(line(number - k) + from, line(number + k) + from);
  });
  const bool fits = pairs_fit(sums + from, to - from);
  if (!fits) halve(sums + from, to - from);
  std::int16_t* smooth = smooth_.data() + run.first;
  weigh(weights_, sums + run.first, run.size(), smooth, [&](int k) {
    return std::pair(sums + run.first - k, sums + run.first + k);
  });
  if (!fits) twice(smooth, run.size());
  return smooth;
}

std::size_t RowSmoother::slot(int number) const {
  const int count = 2 * radius_ + 1;
  return static_cast<std::size_t>((number % count + count) % count);
}

}  // namespace alltact
