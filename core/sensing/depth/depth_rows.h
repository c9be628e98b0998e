// Loops over one pixel row from brightness to differences and flags.
#pragma once

#include <array>
#include <cstdint>

namespace alltact::depth_rows {

/// Converts both brightnesses of a row to steps (image_warp.h). True when every pixel of it can be
/// measured, as in nearly all rows. darkest: minimum of the reference, in steps.
bool copy(const std::uint8_t* grey, const std::int16_t* reference, std::int16_t darkest, int count,
          std::int16_t* live_out, std::int16_t* reference_out);

/// Flags each pixel of a copied row that cannot be measured (depth_map.h), and sets both
/// brightnesses to 0 there.
void mark(std::int16_t darkest, int count, std::int16_t* live, std::int16_t* reference,
          std::uint8_t* flags);

/// A smoothed row, its smoothed reference, and the reference before smoothing.
struct SmoothRow {
  const std::int16_t *live, *reference, *raw;
};

/// x = (reference - q live) / reference; NaN where flags require it. `light`: q in powers of the
/// column; the row's first column is first_column. Between pixels that could not be measured hardly
/// any of the kernel is left, and its outer weights are negative. Such a pixel takes the reason of
/// its neighbours: dark or clipped, whichever level is nearer. Measured values beyond x_max are
/// flagged. all_measured: every flag is kMeasured.
void divide(const SmoothRow& row, bool all_measured, const std::array<float, 3>& light,
            int first_column, float x_max, int count, std::uint8_t* flags, float* x);

/// Flags values beyond x_max, as divide() does.
void flag_beyond(const float* x, float x_max, int count, std::uint8_t* flags);

/// Clamps depths to the layer's thickness, with their sign, and flags them as kBeyondLayer or
/// kBulgeLimit.
void clamp(const float* max_mm, int count, float* depth_mm, std::uint8_t* flags);

}  // namespace alltact::depth_rows
