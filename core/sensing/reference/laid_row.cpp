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

/// `per_place`: steps that the picture itself advances from one place to the next.
[[gnu::always_inline]] inline PieceSteps find_piece(const float* __restrict constant,
                                                    const float* __restrict slope,
                                                    const float* __restrict bow,
                                                    float row,
                                                    float origin,
                                                    int last,
                                                    int per_place) {
  constexpr float kOne = 1 << kPlaceBits;
  std::array<int, kLaidPiece> fixed;
  for (int i = 0; i < kLaidPiece; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const float place = constant[i] + row * (slope[i] + row * bow[i]) - origin;
    const int exact = static_cast<int>(place * kOne + 0.5F);
    const int above = exact > 0 ? exact : 0;
    fixed[k] = (above < last ? above : last) - ((i * per_place) << kPlaceBits);
  }
  PieceSteps piece;
  find_steps(fixed, piece);
  return piece;
}

[[gnu::always_inline]] inline void take_piece(const std::int16_t* __restrict from,
                                              std::ptrdiff_t step,
                                              const PieceSteps& piece,
                                              std::int16_t* __restrict out) {
  std::array<std::int16_t, kLaidPiece> here, next;
  for (std::size_t k = 0; k < kLaidPiece; ++k) here[k] = from[k];
  from += step;
  for (std::size_t k = 0; k < kLaidPiece; ++k) next[k] = from[k];
  const int steps = piece.most - piece.least;
  for (int s = 1; s <= steps; ++s) {
    const std::int16_t* beyond = from + step;
    const auto at = static_cast<std::int16_t>(s);
    for (std::size_t k = 0; k < kLaidPiece; ++k) {
      const bool reaches = piece.steps[k] >= at;
      here[k] = reaches ? from[k] : here[k];
      next[k] = reaches ? beyond[k] : next[k];
    }
    from = beyond;
  }
  for (std::size_t k = 0; k < kLaidPiece; ++k)
    out[k] = static_cast<std::int16_t>(
        here[k] + times(static_cast<std::int16_t>(next[k] - here[k]), piece.part[k]));
}

/// Of the last place that lies before the picture's last pixel.
int last_place(int count) {
  return std::max(0, ((count - 1) << kPlaceBits) - 1);
}

[[gnu::always_inline]] inline void lay(const std::int16_t* picture,
                                       std::ptrdiff_t step,
                                       const LaidPlaces& places,
                                       int last,
                                       int n,
                                       std::int16_t* __restrict out,
                                       int per_place) {
  const float* constant = places.places.constant.data() + places.first;
  const float* slope = places.places.slope.data() + places.first;
  const float* bow = places.places.bow.data() + places.first;
  for (int i = 0; i < n; i += kLaidPiece) {
    const PieceSteps piece =
        find_piece(constant + i, slope + i, bow + i, places.row, places.origin, last, per_place);
    const std::int16_t* from = picture + (per_place != 0 ? 0 : i) + piece.least * step;
    if (per_place == 0) __builtin_prefetch(from + (piece.most - piece.least + kRowsAhead) * step);
    take_piece(from, step, piece, out + i);
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
