// Grey levels interpolated between two pixels a step apart, for many adjacent positions.
#pragma once

#include "core/sensing/reference/face_chart.h"

#include <cstddef>
#include <cstdint>

namespace alltact {

constexpr int kWarpChunk =
    ColumnQuadratics::kBeyond;  ///< positions that are interpolated at a time

/// Mapped positions of a row: column `first` of the polynomials and those after it, at `row`.
struct RowWarp {
  const ColumnQuadratics& positions;
  std::ptrdiff_t first;
  float row;
  float origin;  ///< position of the image's first pixel
  int count;     ///< pixels of the image; positions are clamped to them
};

/// out[i] = the row `image` of grey levels in steps (grey_steps.h) at position i, linear between
/// its pixels to 1/400 px, as `multiply_q15` rounds. kWarpChunk pixels before and behind the row
/// must be readable, whatever they hold; n + kWarpChunk numbers are written.
void warp_along(const std::int16_t* image, const RowWarp& warp, int n, std::int16_t* out);

/// out[i] = pixel i of the image's row at position i, linear between rows as above. `stride`: from
/// row to row; kWarpChunk pixels behind the n must be readable in each row.
void warp_across(const std::int16_t* image,
                 std::ptrdiff_t stride,
                 const RowWarp& warp,
                 int n,
                 std::int16_t* out);

}  // namespace alltact
