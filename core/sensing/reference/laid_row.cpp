#include "core/sensing/reference/laid_row.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/place_steps.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr int kRowsAhead =
    5;  // fetched before they are needed: a picture is larger than the caches

using PieceSteps = PlaceSteps<kLaidPiece>;

/// A place in a row, of 2^-kPlaceBits px.
[[gnu::always_inline]] inline int place_in(
    float constant, float slope, float bow, float row, float origin) {
  constexpr float kOne = 1 << kPlaceBits;
  return static_cast<int>((constant + row * (slope + row * bow) - origin) * kOne + 0.5F);
}

/// `per_place`: steps that the picture itself advances from one place to the next.
[[gnu::always_inline]] inline PieceSteps find_piece(const float* __restrict constant,
                                                    const float* __restrict slope,
                                                    const float* __restrict bow,
                                                    float row,
                                                    float origin,
                                                    int last,
                                                    int per_place) {
  std::array<int, kLaidPiece> fixed;
  for (int i = 0; i < kLaidPiece; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int exact = place_in(constant[i], slope[i], bow[i], row, origin);
    const int above = exact > 0 ? exact : 0;
    fixed[k] = (above < last ? above : last) - ((i * per_place) << kPlaceBits);
  }
  PieceSteps piece;
  find_steps(fixed, piece);
  return piece;
}

/// 16-bit numbers that stay in registers from one step to the next, and where they are read.
using Half = std::int16_t __attribute__((vector_size(32)));
using HalfAt = std::int16_t __attribute__((vector_size(32), aligned(2), may_alias));
using HalfAround = std::uint16_t __attribute__((vector_size(32)));
constexpr std::size_t kHalf = sizeof(Half) / sizeof(std::int16_t);
static_assert(kLaidPiece == 2 * kHalf);

/// Half a piece's grey levels: out[k] at its place k, which lies part[k] of 2^15 of a step behind
/// steps[k]. Finished within the half: read as a whole, two stored halves would wait for memory.
[[gnu::always_inline]] inline void take_half(const std::int16_t* from,
                                             std::ptrdiff_t step,
                                             int steps_apart,
                                             const std::int16_t* steps,
                                             const std::int16_t* part,
                                             std::int16_t* __restrict out) {
  const auto at = [](const std::int16_t* place) __attribute__((always_inline)) {
    return reinterpret_cast<const HalfAt*>(place);
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
  // Places that nobody asked for hold anything: their difference may wrap around.
  *reinterpret_cast<HalfAt*>(further.data()) = reinterpret_cast<Half>(
      reinterpret_cast<HalfAround>(next) - reinterpret_cast<HalfAround>(now));
#pragma GCC unroll 1  // as a loop it runs in vectors
  for (std::size_t k = 0; k < kHalf; ++k)
    out[k] = static_cast<std::int16_t>(here[k] + times(further[k], part[k]));
}

[[gnu::always_inline]] inline void take_piece(const std::int16_t* from,
                                              std::ptrdiff_t step,
                                              const PieceSteps& piece,
                                              std::int16_t* __restrict out) {
  for (std::size_t k = 0; k < kLaidPiece; k += kHalf)
    take_half(from + k,
              step,
              piece.most - piece.least,
              piece.steps.data() + k,
              piece.part.data() + k,
              out + k);
}

/// Of the last place that lies before the picture's last pixel.
int last_place(int count) {
  return std::max(0, ((count - 1) << kPlaceBits) - 1);
}

/// Places of one row at nodes, of 2^-kPlaceBits px.
constexpr int kNodeStep = PlacesByColumn::kNodeStep;
constexpr int kGroup = 64;  // nodes at a time, and one before and two behind them
static_assert(kLaidPiece == 2 * kNodeStep && kGroup % 2 == 0);
using Nodes = std::array<int, kGroup + 3>;

[[gnu::always_inline]] inline void find_nodes(const PlacesByRow& places,
                                              std::size_t first,
                                              int count,
                                              float row,
                                              float origin,
                                              Nodes& nodes) {
  const float* constant = places.constant.data() + first;
  const float* slope = places.slope.data() + first;
  const float* bow = places.bow.data() + first;
  constexpr int kFar = 1 << 27;  // far outside every picture; 8 of them still are an int
  for (int i = 0; i < count; ++i) {
    const int exact = place_in(constant[i], slope[i], bow[i], row, origin);
    const int above = exact > -kFar ? exact : -kFar;
    nodes[static_cast<std::size_t>(i)] = above < kFar ? above : kFar;
  }
}

/// The parabola through a piece's first place and that behind its last, by its place k: of their
/// way apart k / 32, and of what the one between them lies off their middle 4 k / 32 (1 - k / 32).
struct PieceShares {
  alignas(64) std::array<std::int16_t, kLaidPiece> way, bend;
};
constexpr PieceShares kShares = [] {
  PieceShares shares{};
  for (int k = 0; k < kLaidPiece; ++k) {
    constexpr int kWhole = 1 << 15;
    const auto i = static_cast<std::size_t>(k);
    shares.way[i] = static_cast<std::int16_t>(k * (kWhole / kLaidPiece));
    const int bend = 4 * k * (kLaidPiece - k) * (kWhole / (kLaidPiece * kLaidPiece));
    shares.bend[i] = static_cast<std::int16_t>(bend < kWhole ? bend : kWhole - 1);
  }
  return shares;
}();

/// A piece's places by three nodes, in 16-bit numbers. false where these cannot hold them, where
/// some would have to be clamped, and where the nodes before and behind them tell that a parabola
/// is off by more than 1/500 px: at most a 15th of the nodes' third differences.
[[gnu::always_inline]] inline bool find_smooth_piece(const int* nodes,
                                                     int last,
                                                     int per_place,
                                                     PieceSteps& piece) {
  constexpr int kMostSpread = INT16_MAX - (1 << kPlaceBits);
  constexpr int kMostThird = 15 * (1 << kPlaceBits) / 500;
  const int begin = nodes[0], end = nodes[2];
  for (const int third :
       {end - nodes[-1] + 3 * (begin - nodes[1]), nodes[3] - begin + 3 * (nodes[1] - end)})
    if (third > kMostThird || -third > kMostThird) return false;
  const int bend = nodes[1] - (begin + end) / 2, most_bend = bend < 0 ? -bend : bend;
  const int way = end - begin - ((kLaidPiece * per_place) << kPlaceBits);
  if (way > kMostSpread - most_bend || -way > kMostSpread - most_bend) return false;
  const int low = begin < end ? begin : end, high = begin < end ? end : begin;
  if (low - most_bend < 0 || high + most_bend > last) return false;
  const auto way_16 = static_cast<std::int16_t>(way), bend_16 = static_cast<std::int16_t>(bend);
  alignas(64) std::array<std::int16_t, kLaidPiece> from_begin;
  std::int16_t least = 0, most = 0;
  for (std::size_t k = 0; k < kLaidPiece; ++k) {
    const auto here =
        static_cast<std::int16_t>(times(kShares.way[k], way_16) + times(kShares.bend[k], bend_16));
    from_begin[k] = here;
    least = here < least ? here : least;
    most = here > most ? here : most;
  }
  piece.least = (begin + least) >> kPlaceBits;
  piece.most = (begin + most) >> kPlaceBits;
  const auto base = static_cast<std::int16_t>(begin - piece.least * (1 << kPlaceBits));
  constexpr std::int16_t kFraction = (1 << kPlaceBits) - 1;
  for (std::size_t k = 0; k < kLaidPiece; ++k) {
    const auto place = static_cast<std::int16_t>(from_begin[k] + base);
    piece.steps[k] = static_cast<std::int16_t>(place >> kPlaceBits);
    piece.part[k] = static_cast<std::int16_t>((place & kFraction) << (15 - kPlaceBits));
  }
  return true;
}

[[gnu::always_inline]] inline void lay(const std::int16_t* picture,
                                       std::ptrdiff_t step,
                                       const LaidPlaces& laid,
                                       int last,
                                       int n,
                                       std::int16_t* __restrict out,
                                       int per_place) {
  const PlacesByColumn& places = laid.places;
  const auto exactly = [&](int i, PieceSteps& piece) __attribute__((always_inline)) {
    const std::ptrdiff_t column = laid.first + i;
    piece = find_piece(places.constant.data() + column,
                       places.slope.data() + column,
                       places.bow.data() + column,
                       laid.row,
                       laid.origin,
                       last,
                       per_place);
  };
  const auto take = [&](int i, const PieceSteps& piece) __attribute__((always_inline)) {
    const std::int16_t* from = picture + (per_place != 0 ? 0 : i) + piece.least * step;
    if (per_place == 0) __builtin_prefetch(from + (piece.most - piece.least + kRowsAhead) * step);
    take_piece(from, step, piece, out + i);
  };
  PieceSteps piece;
  // Nodes lie where whole pieces begin.
  const auto ahead = static_cast<int>((kLaidPiece - laid.first % kLaidPiece) % kLaidPiece);
  if (ahead != 0) {
    exactly(0, piece);
    take(0, piece);
  }
  Nodes nodes;
  for (int group = ahead; group < n; group += kGroup * kNodeStep) {
    const auto node = static_cast<std::size_t>(laid.first + group) / kNodeStep;
    const std::size_t before = node > 0 ? 1 : 0;
    const int end = std::min(n, group + kGroup * kNodeStep);
    const int pieces = (end - group + kLaidPiece - 1) / kLaidPiece;
    find_nodes(places.nodes,
               node - before,
               2 * pieces + 2 + static_cast<int>(before),
               laid.row,
               laid.origin,
               nodes);
    for (int i = group; i < end; i += kLaidPiece) {
      const std::ptrdiff_t column = laid.first + i;
      const bool is_inside = column > 0 && column + kLaidPiece < places.columns;
      const int* at = nodes.data() + before + (i - group) / kNodeStep;
      if (!is_inside || !find_smooth_piece(at, last, per_place, piece)) exactly(i, piece);
      take(i, piece);
    }
  }
}

ALLTACT_WIDE void lay_row_along(
    const std::int16_t* picture, const LaidPlaces& places, int last, int n, std::int16_t* out) {
  lay(picture, 1, places, last, n, out, 1);
}

ALLTACT_WIDE void lay_row_across(const std::int16_t* picture,
                                 std::ptrdiff_t stride,
                                 const LaidPlaces& places,
                                 int last,
                                 int n,
                                 std::int16_t* out) {
  lay(picture, stride, places, last, n, out, 0);
}

}  // namespace

void lay_along(const std::int16_t* picture, const LaidPlaces& places, int n, std::int16_t* out) {
  lay_row_along(picture, places, last_place(places.count), n, out);
}

void lay_across(const std::int16_t* picture,
                std::ptrdiff_t stride,
                const LaidPlaces& places,
                int n,
                std::int16_t* out) {
  lay_row_across(picture, stride, places, last_place(places.count), n, out);
}

}  // namespace alltact
