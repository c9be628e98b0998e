#include "core/sensing/reference/warped_row.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/position_steps.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr int kRowsAhead = 5;  // prefetched, because an image is larger than the caches

using PieceSteps = PositionSteps<kWarpChunk>;

/// A position in a row, in units of 2^-kPositionBits px.
[[gnu::always_inline]] inline int position_in(
    float constant, float slope, float bow, float row, float origin) {
  constexpr float kOne = 1 << kPositionBits;
  return static_cast<int>((constant + row * (slope + row * bow) - origin) * kOne + 0.5F);
}

/// `per_position`: steps that the read window advances from one position to the next.
[[gnu::always_inline]] inline PieceSteps find_piece(const float* __restrict constant,
                                                    const float* __restrict slope,
                                                    const float* __restrict bow,
                                                    float row,
                                                    float origin,
                                                    int last,
                                                    int per_position) {
  std::array<int, kWarpChunk> fixed;
  for (int i = 0; i < kWarpChunk; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int exact = position_in(constant[i], slope[i], bow[i], row, origin);
    const int above = exact > 0 ? exact : 0;
    fixed[k] = (above < last ? above : last) - ((i * per_position) << kPositionBits);
  }
  PieceSteps piece;
  find_steps(fixed, piece);
  return piece;
}

/// 16-bit numbers that stay in registers from one step to the next, and their unaligned form.
using Half = std::int16_t __attribute__((vector_size(32)));
using HalfAt = std::int16_t __attribute__((vector_size(32), aligned(2), may_alias));
using HalfAround = std::uint16_t __attribute__((vector_size(32)));
constexpr std::size_t kHalf = sizeof(Half) / sizeof(std::int16_t);
static_assert(kWarpChunk == 2 * kHalf);

/// Half a chunk's grey levels: out[k] at its position k, which lies part[k] of 2^15 of a step
/// behind steps[k]. Each half is finished by itself: loading two stored halves at once would stall.
[[gnu::always_inline]] inline void take_half(const std::int16_t* from,
                                             std::ptrdiff_t step,
                                             int steps_apart,
                                             const std::int16_t* steps,
                                             const std::int16_t* part,
                                             std::int16_t* __restrict out) {
  const auto at = [](const std::int16_t* address) __attribute__((always_inline)) {
    return reinterpret_cast<const HalfAt*>(address);
  };
  const Half own = *at(steps);
  Half now = *at(from), next = *at(from + step);
  for (int s = 1; s <= steps_apart; ++s) {
    from += step;
    const Half reaches = own >= static_cast<std::int16_t>(s);
    const Half candidate = *at(from), beyond = *at(from + step);
    now = (candidate & reaches) | (now & ~reaches);
    next = (beyond & reaches) | (next & ~reaches);
  }
  alignas(Half) std::array<std::int16_t, kHalf> here, further;
  *reinterpret_cast<HalfAt*>(here.data()) = now;
  // Positions outside of the request hold anything: their difference may wrap around.
  *reinterpret_cast<HalfAt*>(further.data()) = reinterpret_cast<Half>(
      reinterpret_cast<HalfAround>(next) - reinterpret_cast<HalfAround>(now));
#pragma GCC unroll 1  // as a loop it is vectorised
  for (std::size_t k = 0; k < kHalf; ++k)
    out[k] = static_cast<std::int16_t>(here[k] + multiply_q15(further[k], part[k]));
}

[[gnu::always_inline]] inline void take_piece(const std::int16_t* from,
                                              std::ptrdiff_t step,
                                              const PieceSteps& piece,
                                              std::int16_t* __restrict out) {
  for (std::size_t k = 0; k < kWarpChunk; k += kHalf)
    take_half(from + k,
              step,
              piece.max_step - piece.min_step,
              piece.steps.data() + k,
              piece.part.data() + k,
              out + k);
}

/// The last position that lies before the image's last pixel.
int last_position(int count) {
  return std::max(0, ((count - 1) << kPositionBits) - 1);
}

/// Positions of one row at nodes, in units of 2^-kPositionBits px.
constexpr int kNodeStep = ColumnQuadratics::kNodeStep;
constexpr int kGroup = 64;  // nodes at a time, plus one before and two behind them
static_assert(kWarpChunk == 2 * kNodeStep && kGroup % 2 == 0);
using Nodes = std::array<int, kGroup + 3>;

[[gnu::always_inline]] inline void find_nodes(const RowQuadratics& positions,
                                              std::size_t first,
                                              int count,
                                              float row,
                                              float origin,
                                              Nodes& nodes) {
  const float* constant = positions.constant.data() + first;
  const float* slope = positions.slope.data() + first;
  const float* bow = positions.bow.data() + first;
  constexpr int kFar = 1 << 27;  // far outside of every image; 8 of them still fit an int
  for (int i = 0; i < count; ++i) {
    const int exact = position_in(constant[i], slope[i], bow[i], row, origin);
    const int above = exact > -kFar ? exact : -kFar;
    nodes[static_cast<std::size_t>(i)] = above < kFar ? above : kFar;
  }
}

/// Weights of the parabola through a chunk's first position and that behind its last, by position
/// k. The span between both ends has weight k / 32; the midpoint's offset from their mean has
/// weight 4 k / 32 (1 - k / 32).
struct PieceShares {
  alignas(64) std::array<std::int16_t, kWarpChunk> span, bend;
};
constexpr PieceShares kShares = [] {
  PieceShares shares{};
  for (int k = 0; k < kWarpChunk; ++k) {
    constexpr int kOneQ15 = 1 << 15;
    const auto i = static_cast<std::size_t>(k);
    shares.span[i] = static_cast<std::int16_t>(k * (kOneQ15 / kWarpChunk));
    const int bend = 4 * k * (kWarpChunk - k) * (kOneQ15 / (kWarpChunk * kWarpChunk));
    shares.bend[i] = static_cast<std::int16_t>(bend < kOneQ15 ? bend : kOneQ15 - 1);
  }
  return shares;
}();

/// A chunk's positions from three nodes, in 16-bit numbers. false where these overflow, and where
/// some would have to be clamped. Also false where the nodes before and behind them show that the
/// parabola's error exceeds 1/500 px: at most a 15th of the nodes' third differences.
[[gnu::always_inline]] inline bool find_smooth_piece(const int* nodes,
                                                     int last,
                                                     int per_position,
                                                     PieceSteps& piece) {
  constexpr int kMaxSpread = INT16_MAX - (1 << kPositionBits);
  constexpr int kMaxThird = 15 * (1 << kPositionBits) / 500;
  const int begin = nodes[0], end = nodes[2];
  for (const int third :
       {end - nodes[-1] + 3 * (begin - nodes[1]), nodes[3] - begin + 3 * (nodes[1] - end)})
    if (third > kMaxThird || -third > kMaxThird) return false;
  const int bend = nodes[1] - (begin + end) / 2, bend_size = bend < 0 ? -bend : bend;
  const int span = end - begin - ((kWarpChunk * per_position) << kPositionBits);
  if (span > kMaxSpread - bend_size || -span > kMaxSpread - bend_size) return false;
  const int low = begin < end ? begin : end, high = begin < end ? end : begin;
  if (low - bend_size < 0 || high + bend_size > last) return false;
  const auto span_16 = static_cast<std::int16_t>(span), bend_16 = static_cast<std::int16_t>(bend);
  alignas(64) std::array<std::int16_t, kWarpChunk> from_begin;
  std::int16_t min_offset = 0, max_offset = 0;
  for (std::size_t k = 0; k < kWarpChunk; ++k) {
    const auto here = static_cast<std::int16_t>(multiply_q15(kShares.span[k], span_16) +
                                                multiply_q15(kShares.bend[k], bend_16));
    from_begin[k] = here;
    min_offset = here < min_offset ? here : min_offset;
    max_offset = here > max_offset ? here : max_offset;
  }
  piece.min_step = (begin + min_offset) >> kPositionBits;
  piece.max_step = (begin + max_offset) >> kPositionBits;
  const auto base = static_cast<std::int16_t>(begin - piece.min_step * (1 << kPositionBits));
  constexpr std::int16_t kFraction = (1 << kPositionBits) - 1;
  for (std::size_t k = 0; k < kWarpChunk; ++k) {
    const auto position = static_cast<std::int16_t>(from_begin[k] + base);
    piece.steps[k] = static_cast<std::int16_t>(position >> kPositionBits);
    piece.part[k] = static_cast<std::int16_t>((position & kFraction) << (15 - kPositionBits));
  }
  return true;
}

[[gnu::always_inline]] inline void warp_row(const std::int16_t* image,
                                            std::ptrdiff_t step,
                                            const RowWarp& warp,
                                            int last,
                                            int n,
                                            std::int16_t* __restrict out,
                                            int per_position) {
  const ColumnQuadratics& positions = warp.positions;
  const auto exactly = [&](int i, PieceSteps& piece) __attribute__((always_inline)) {
    const std::ptrdiff_t column = warp.first + i;
    piece = find_piece(positions.constant.data() + column,
                       positions.slope.data() + column,
                       positions.bow.data() + column,
                       warp.row,
                       warp.origin,
                       last,
                       per_position);
  };
  const auto take = [&](int i, const PieceSteps& piece) __attribute__((always_inline)) {
    const std::int16_t* from = image + (per_position != 0 ? 0 : i) + piece.min_step * step;
    if (per_position == 0)
      __builtin_prefetch(from + (piece.max_step - piece.min_step + kRowsAhead) * step);
    take_piece(from, step, piece, out + i);
  };
  PieceSteps piece;
  // Nodes lie where full chunks begin.
  const auto ahead = static_cast<int>((kWarpChunk - warp.first % kWarpChunk) % kWarpChunk);
  if (ahead != 0) {
    exactly(0, piece);
    take(0, piece);
  }
  Nodes nodes;
  for (int group = ahead; group < n; group += kGroup * kNodeStep) {
    const auto node = static_cast<std::size_t>(warp.first + group) / kNodeStep;
    const std::size_t before = node > 0 ? 1 : 0;
    const int end = std::min(n, group + kGroup * kNodeStep);
    const int pieces = (end - group + kWarpChunk - 1) / kWarpChunk;
    find_nodes(positions.nodes,
               node - before,
               2 * pieces + 2 + static_cast<int>(before),
               warp.row,
               warp.origin,
               nodes);
    for (int i = group; i < end; i += kWarpChunk) {
      const std::ptrdiff_t column = warp.first + i;
      const bool is_inside = column > 0 && column + kWarpChunk < positions.columns;
      const int* at = nodes.data() + before + (i - group) / kNodeStep;
      if (!is_inside || !find_smooth_piece(at, last, per_position, piece)) exactly(i, piece);
      take(i, piece);
    }
  }
}

ALLTACT_WIDE void warp_row_along(
    const std::int16_t* image, const RowWarp& warp, int last, int n, std::int16_t* out) {
  warp_row(image, 1, warp, last, n, out, 1);
}

ALLTACT_WIDE void warp_row_across(const std::int16_t* image,
                                  std::ptrdiff_t stride,
                                  const RowWarp& warp,
                                  int last,
                                  int n,
                                  std::int16_t* out) {
  warp_row(image, stride, warp, last, n, out, 0);
}

}  // namespace

void warp_along(const std::int16_t* image, const RowWarp& warp, int n, std::int16_t* out) {
  warp_row_along(image, warp, last_position(warp.count), n, out);
}

void warp_across(const std::int16_t* image,
                 std::ptrdiff_t stride,
                 const RowWarp& warp,
                 int n,
                 std::int16_t* out) {
  warp_row_across(image, stride, warp, last_position(warp.count), n, out);
}

}  // namespace alltact
