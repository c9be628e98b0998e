#include "core/sensing/depth/smoothing.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/vector_loops.h"
#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include <Eigen/Dense>

namespace alltact {

double Smoothing::noise_factor() const {
  double squares = weights.front() * weights.front();
  for (std::size_t k = 1; k < weights.size(); ++k) squares += 2.0 * weights[k] * weights[k];
  return squares;  // the root for either axis, and there are two
}

Smoothing smoothing_of(double smoothing_px) {
  constexpr double kWider = 2.7;  // than a Gaussian that leaves the same noise
  constexpr double kReach = 2.2;  // standard deviations
  if (!(smoothing_px > 0.0)) return {};
  const double sd = kWider * smoothing_px;
  const int reach = std::max(2, static_cast<int>(std::ceil(kReach * sd)));
  // Moments of the Gaussian on integer pixels, for a sum of 1 and the target variance.
  double moments[3] = {0, 0, 0};
  const auto gauss = [sd](int k) { return std::exp(-0.5 * k * k / (sd * sd)); };
  for (int k = -reach; k <= reach; ++k) {
    const double square = static_cast<double>(k) * k;
    moments[0] += gauss(k);
    moments[1] += gauss(k) * square;
    moments[2] += gauss(k) * square * square;
  }
  Eigen::Matrix2d system;
  system << moments[0], moments[1], moments[1], moments[2];
  const Eigen::Vector2d part = system.inverse() * Eigen::Vector2d(1.0, -kOpticsPx2);
  Smoothing smoothing{{}, -kOpticsPx2};
  for (int k = 0; k <= reach; ++k)
    smoothing.weights.push_back(gauss(k) * (part[0] + part[1] * k * k));
  return smoothing;
}

Smoothing gaussian_smoothing(double smoothing_px) {
  if (!(smoothing_px > 0.0)) return {};
  const int reach = static_cast<int>(std::ceil(2.0 * smoothing_px));
  Smoothing smoothing{{}, 0.0};
  double sum = 0;
  for (int k = 0; k <= reach; ++k) {
    const double weight = std::exp(-0.5 * k * k / (smoothing_px * smoothing_px));
    smoothing.weights.push_back(weight);
    sum += (k == 0 ? 1.0 : 2.0) * weight;
    smoothing.variance_px2 += 2.0 * weight * k * k;
  }
  smoothing.variance_px2 /= sum;
  for (double& weight : smoothing.weights) weight /= sum;
  return smoothing;
}

namespace {

constexpr int kMaxPairs = 6;  // at once: as many vectors as registers hold

/// Pixels and their neighbours before and behind them, at some distances.
struct NearPixels {
  const std::int16_t* middle;  // nullptr: continues with the sums in `out`
  std::int16_t own;            // weight of the middle
  std::array<const std::int16_t*, kMaxPairs> before, behind;
  std::array<std::int16_t, kMaxPairs> weights;
};

/// out = weighted sum of the middle and its neighbours, in one pass. Input is such that a pair's
/// sum fits into 16 bits; intermediate sums may wrap around. Returns the largest sum if requested,
/// at least 0.
template <bool kLargest, std::size_t... kPair>
[[gnu::always_inline]] inline std::int16_t convolve_pairs(const NearPixels& given, int count,
                                                          std::int16_t* __restrict out,
                                                          std::index_sequence<kPair...>) {
  const NearPixels near = given;
  const auto pairs_at = [&](int i) __attribute__((always_inline)) {
    return (... +
            multiply_q15(static_cast<std::int16_t>(near.before[kPair][i] + near.behind[kPair][i]),
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
  // By lane of a block; reduced once at the end, not in every block.
  std::array<std::int16_t, kBlock> largest_by_lane{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        for (int k = 0; k < size; ++k) {
          const int i = first + k;
          const auto sum =
              static_cast<std::int16_t>(multiply_q15(near.middle[i], near.own) + pairs_at(i));
          out[i] = sum;
          std::int16_t& here = largest_by_lane[static_cast<std::size_t>(k)];
          if constexpr (kLargest) here = sum > here ? sum : here;
        }
      });
  return kLargest ? max_of(largest_by_lane) : std::int16_t{0};
}

template <bool kLargest>
[[gnu::always_inline]] inline std::int16_t convolve_count(const NearPixels& near, int pairs,
                                                          int count, std::int16_t* out) {
  switch (pairs) {
    case 2:
      return convolve_pairs<kLargest>(near, count, out, std::make_index_sequence<2>());
    case 4:
      return convolve_pairs<kLargest>(near, count, out, std::make_index_sequence<4>());
    default:
      return convolve_pairs<kLargest>(near, count, out, std::make_index_sequence<kMaxPairs>());
  }
}

ALLTACT_WIDE std::int16_t convolve_columns(const NearPixels& near, int pairs, int count,
                                           std::int16_t* out) {
  return convolve_count<true>(near, pairs, count, out);
}
ALLTACT_WIDE std::int16_t convolve_row(const NearPixels& near, int pairs, int count,
                                       std::int16_t* out) {
  return convolve_count<false>(near, pairs, count, out);
}

/// A kernel's weights in units of 2^-15, of the middle and of an even number of distances from it.
/// Outer ones are multiples of 2^-9: products of integer grey levels then lose little. Otherwise
/// the rounding, alike in every pixel, would bias dark faces.
std::vector<std::int16_t> fixed_weights(const Smoothing& smoothing) {
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

/// The outer weights are negative: where those pixels are missing, a column's sum may exceed the
/// brightest pixel. Above this limit the sum of a pair would overflow.
constexpr std::int16_t kMaxOfPair = INT16_MAX / 2;

ALLTACT_WIDE void halve(std::int16_t* sums, int count) {
  for (int i = 0; i < count; ++i) sums[i] = static_cast<std::int16_t>((sums[i] + 1) >> 1);
}
ALLTACT_WIDE void double_back(std::int16_t* smooth, int count) {
  for (int i = 0; i < count; ++i) smooth[i] = static_cast<std::int16_t>(2 * smooth[i]);
}

/// neighbours(k): the pixels k before and k behind the first of `middle`. Returns the result of
/// `some`.
template <class Some, class At>
std::int16_t convolve(const std::vector<std::int16_t>& weights, const std::int16_t* middle,
                      int count, std::int16_t* out, Some some, At neighbours) {
  const int radius = static_cast<int>(weights.size()) - 1;
  std::int16_t largest = 0;
  for (int done = 0; done < radius; done += kMaxPairs) {
    NearPixels near{done == 0 ? middle : nullptr, weights.front(), {}, {}, {}};
    const int pairs = std::min(kMaxPairs, radius - done);
    for (int k = 0; k < pairs; ++k) {
      const auto i = static_cast<std::size_t>(k);
      std::tie(near.before[i], near.behind[i]) = neighbours(done + k + 1);
      near.weights[i] = weights[static_cast<std::size_t>(std::ptrdiff_t{done} + k + 1)];
    }
    largest = some(near, pairs, count, out);
  }
  return largest;
}

}  // namespace

RowSmoother::RowSmoother(const Smoothing& smoothing, int width)
    : weights_(fixed_weights(smoothing)),
      radius_(static_cast<int>(weights_.size()) - 1),
      width_(width),
      step_(width + 2 * radius_),
      slots_(std::bit_ceil(static_cast<std::size_t>(std::ptrdiff_t{2} * radius_ + 1))),
      rows_(slots_ * static_cast<std::size_t>(step_), 0),
      filled_(slots_),
      sums_(static_cast<std::size_t>(step_), 0),
      smooth_(static_cast<std::size_t>(width)) {}

std::int16_t* RowSmoother::begin_row(int number, std::span<const FaceRun> runs) {
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
  // Pixels outside of the image count as 0.
  std::fill(sums + run.first - radius_, sums + from, std::int16_t{0});
  std::fill(sums + to, sums + run.end + radius_, std::int16_t{0});
  const std::int16_t largest =
      convolve(weights_, line(number) + from, to - from, sums + from, convolve_columns,
               [&](int k) { return std::pair(line(number - k) + from, line(number + k) + from); });
  const bool fits = largest <= kMaxOfPair;
  if (!fits) halve(sums + from, to - from);
  std::int16_t* smooth = smooth_.data() + run.first;
  convolve(weights_, sums + run.first, run.size(), smooth, convolve_row,
           [&](int k) { return std::pair(sums + run.first - k, sums + run.first + k); });
  if (!fits) double_back(smooth, run.size());
  return smooth;
}

}  // namespace alltact
