// The loops over a row of pixels that depth is made by: brightness in, differences and flags out.
#pragma once

#include <array>
#include <cstdint>

namespace alltact::depth_rows {

/// Both brightnesses of a row in steps (grey_steps.h); true when every pixel of it can be measured,
/// as nearly all rows can. darkest: of the reference, in steps.
bool copy(const std::uint8_t* grey,
          const std::int16_t* reference,
          std::int16_t darkest,
          int count,
          std::int16_t* live_out,
          std::int16_t* reference_out);

/// Says of each pixel of a row that was copied whether it can be measured (pixel_flags.h), and sets
/// both brightnesses to 0 where not.
void mark(std::int16_t darkest,
          int count,
          std::int16_t* live,
          std::int16_t* reference,
          std::uint8_t* flags);

/// A row smoothed, and its reference before that.
struct SmoothRow {
  const std::int16_t *live, *reference, *raw;
};

/// x = (reference - q live) / reference; NaN where flags say so. `light`: q in powers of the
/// column, of which the row's first is first_column. Amid pixels that could not be measured hardly
/// any of the kernel is left, and its outer weights are negative: such a pixel takes the reason of
/// those around it, by whether it is nearer to black or to clipped. What is measured and beyond
/// x_max is flagged as such. all_measured: every flag is kMeasured.
void divide(const SmoothRow& row,
            bool all_measured,
            const std::array<float, 3>& light,
            int first_column,
            float x_max,
            int count,
            std::uint8_t* flags,
            float* x);

/// Flags what lies beyond x_max, as divide() does.
void flag_beyond(const float* x, float x_max, int count, std::uint8_t* flags);

/// A layer cannot be pressed in further than it is thick, nor bulge by more: such depths are set to
/// that, with their sign, and flagged as kBeyondLayer or kBulgeLimit.
void bound(const float* most_mm, int count, float* depth_mm, std::uint8_t* flags);

}  // namespace alltact::depth_rows
