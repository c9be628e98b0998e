// Grey levels looked up between two pixels that lie a step apart, for many places side by side.
#pragma once

#include "core/sensing/reference/face_chart.h"

#include <cstddef>
#include <cstdint>

namespace alltact {

constexpr int kLaidPiece = PlacesByColumn::kBeyond;  ///< places that are looked up at a time

/// Where a row of places lies: column `first` of `places` and those after it, at `row`.
struct LaidPlaces {
  const PlacesByColumn& places;
  std::ptrdiff_t first;
  float row;
  float origin;  ///< place of the picture's first pixel
  int count;     ///< pixels of the picture; places are clamped to them
};

/// out[i] = the row `picture` of grey levels in steps (grey_steps.h) at place i, linear between
/// its pixels to 1/400 px, as `times` rounds. `picture` must be readable, whatever it holds,
/// kLaidPiece pixels beyond both ends; n + kLaidPiece numbers are written.
void lay_along(const std::int16_t* picture, const LaidPlaces& places, int n, std::int16_t* out);

/// out[i] = pixel i of the picture's row at place i, linear between rows as above. `stride`: from
/// row to row; kLaidPiece pixels beyond the n must be readable in each row.
void lay_across(const std::int16_t* picture,
                std::ptrdiff_t stride,
                const LaidPlaces& places,
                int n,
                std::int16_t* out);

}  // namespace alltact
