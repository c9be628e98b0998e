#include "core/sensing/depth/depth_rows.h"

#include "core/image/grey_range.h"
#include "core/numerics/dispatch.h"
#include "core/numerics/vector_loops.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <limits>

namespace alltact::depth_rows {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::int16_t kCeiling = kClippedFrom * kGreySteps;

/// Converts both brightnesses of a row to steps. True when every pixel of it can be measured, as in
/// nearly all rows.
ALLTACT_WIDE bool copy_row(const std::uint8_t* __restrict grey,
                           const std::int16_t* __restrict reference, std::int16_t darkest,
                           int count, std::int16_t* __restrict live_out,
                           std::int16_t* __restrict reference_out) {
  // By lane of a block; reduced once at the end, not in every block.
  std::array<std::int16_t, kBlock> brightest{}, darkest_seen;
  darkest_seen.fill(kCeiling);
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        for (int k = 0; k < size; ++k) {
          const int u = first + k;
          const auto live = static_cast<std::int16_t>(grey[u] * kGreySteps);
          const std::int16_t ref = reference[u];
          live_out[u] = live;
          reference_out[u] = ref;
          const std::int16_t brighter = live > ref ? live : ref;
          std::int16_t& max_value = brightest[static_cast<std::size_t>(k)];
          std::int16_t& min_value = darkest_seen[static_cast<std::size_t>(k)];
          max_value = brighter > max_value ? brighter : max_value;
          min_value = ref < min_value ? ref : min_value;
        }
      });
  return max_of(brightest) < kCeiling && min_of(darkest_seen) >= darkest;
}

/// Flags each pixel of a row that cannot be measured, and sets both brightnesses to 0 there.
ALLTACT_WIDE void mark_row(std::int16_t darkest, int count, std::int16_t* __restrict live,
                           std::int16_t* __restrict reference, std::uint8_t* __restrict flags) {
  constexpr std::int16_t measured = kMeasured, unknown = kNoReference, dark = kTooDark,
                         clipped = kSaturated;
  for (int u = 0; u < count; ++u) {
    const std::int16_t ref = reference[u], now = live[u];
    // The last reason wins; each pixel takes the same steps, so that the loop is vectorised.
    std::int16_t flag = now >= kCeiling ? clipped : measured;
    flag = ref >= kCeiling ? clipped : flag;
    flag = ref < darkest ? dark : flag;
    flag = ref == kNoGrey ? unknown : flag;
    // A mask: a conditional would become a branch.
    const auto mask = static_cast<std::int16_t>(-static_cast<std::int16_t>(flag == measured));
    flags[u] = static_cast<std::uint8_t>(flag);
    live[u] = static_cast<std::int16_t>(now & mask);
    reference[u] = static_cast<std::int16_t>(ref & mask);
  }
}

constexpr float kMinKernelPart = 0.2F;  // of the kernel: 0.3 is left in a corner of the face

constexpr std::array<float, kBlock> kIndices = [] {
  std::array<float, kBlock> indices{};
  for (std::size_t k = 0; k < indices.size(); ++k) indices[k] = static_cast<float>(k);
  return indices;
}();

/// Fast path of divide_row() for rows without flags. Returns false where a pixel needs a flag,
/// which few rows do.
ALLTACT_WIDE bool divide_plain_row(const SmoothRow& row, const std::array<float, 3>& light,
                                   int first_column, float x_max, int count, float* __restrict x) {
  const SmoothRow from = row;
  const float constant = light[0], slope = light[1], bow = light[2];
  std::array<std::int32_t, kBlock> special{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        const auto begin = static_cast<float>(first_column + first);
        for (int k = 0; k < size; ++k) {
          const int u = first + k;
          const float column = begin + kIndices[static_cast<std::size_t>(k)];
          const float correction = constant + column * (slope + column * bow);
          const auto here = static_cast<float>(from.raw[u]);
          const auto below = static_cast<float>(from.reference[u]);
          const float value = (below - correction * static_cast<float>(from.live[u])) / below;
          x[u] = value;
          const std::int32_t thin = below > kMinKernelPart * here ? 0 : 1;
          const std::int32_t beyond = value <= x_max ? 0 : 1;
          special[static_cast<std::size_t>(k)] |= thin | beyond;
        }
      });
  return max_of(special) == 0;
}

/// `light`: factor for live pixels, in powers of u - first_column. Between pixels that could not be
/// measured hardly any of the kernel is left, and its outer weights are negative. Such a pixel
/// takes the reason of its neighbours: dark or clipped, whichever level is nearer. Measured values
/// beyond x_max are flagged.
ALLTACT_WIDE void divide_row(const SmoothRow& row, std::uint8_t* __restrict flags,
                             const std::array<float, 3>& light, int first_column, float x_max,
                             int count, float* __restrict x) {
  constexpr float measured = kMeasured, clipped = kSaturated, dark = kTooDark,
                  extrapolated = kExtrapolated;
  constexpr float kMiddle = 0.5F * kCeiling;
  const SmoothRow from = row;
  const float constant = light[0], slope = light[1], bow = light[2];
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        const auto begin = static_cast<float>(first_column + first);
        // In three loops: in one the compiler would branch for each pixel.
        std::array<float, kBlock> reason, values;
        for (int k = 0; k < size; ++k) {
          const auto before = static_cast<float>(static_cast<std::int32_t>(flags[first + k]));
          // the row may be divided twice
          const float flag = before == extrapolated ? measured : before;
          const auto here = static_cast<float>(from.raw[first + k]);
          const auto smooth = static_cast<float>(from.reference[first + k]);
          const float thin = here > kMiddle ? clipped : dark;
          const float left = smooth > kMinKernelPart * here ? measured : thin;
          reason[static_cast<std::size_t>(k)] = flag == measured ? left : flag;
        }
        for (int k = 0; k < size; ++k) {
          const float column = begin + kIndices[static_cast<std::size_t>(k)];
          const float correction = constant + column * (slope + column * bow);
          const auto live = static_cast<float>(from.live[first + k]);
          const auto smooth = static_cast<float>(from.reference[first + k]);
          const float value = (smooth - correction * live) / smooth;
          values[static_cast<std::size_t>(k)] =
              reason[static_cast<std::size_t>(k)] == measured ? value : kNaN;
        }
        for (int k = 0; k < size; ++k) {
          const float value = values[static_cast<std::size_t>(k)];
          const float final = value > x_max ? extrapolated : reason[static_cast<std::size_t>(k)];
          x[first + k] = value;
          flags[first + k] = static_cast<std::uint8_t>(static_cast<std::int32_t>(final));
        }
      });
}

ALLTACT_WIDE void flag_row(const float* __restrict x, float x_max, int count,
                           std::uint8_t* __restrict flags) {
  constexpr float beyond = kExtrapolated;
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        for (int u = first; u < first + size; ++u) {
          const auto flag = static_cast<float>(static_cast<std::int32_t>(flags[u]));
          flags[u] =
              static_cast<std::uint8_t>(static_cast<std::int32_t>(x[u] > x_max ? beyond : flag));
        }
      });
}

ALLTACT_WIDE void clamp_row(const float* __restrict max_mm, int count, float* __restrict depth_mm,
                            std::uint8_t* __restrict flags) {
  std::array<std::int32_t, kBlock> deeper{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        for (int k = 0; k < size; ++k)
          deeper[static_cast<std::size_t>(k)] |=
              std::abs(depth_mm[first + k]) > max_mm[first + k] ? 1 : 0;
      });
  if (max_of(deeper) == 0) return;  // true for nearly all rows
  for (int u = 0; u < count; ++u) {
    const float max_value = max_mm[u];
    if (!(std::abs(depth_mm[u]) > max_value)) continue;
    flags[u] = depth_mm[u] > 0.0F ? kBeyondLayer : kBulgeLimit;
    depth_mm[u] = std::copysign(max_value, depth_mm[u]);
  }
}

}  // namespace

bool copy(const std::uint8_t* grey, const std::int16_t* reference, std::int16_t darkest, int count,
          std::int16_t* live_out, std::int16_t* reference_out) {
  return copy_row(grey, reference, darkest, count, live_out, reference_out);
}

void mark(std::int16_t darkest, int count, std::int16_t* live, std::int16_t* reference,
          std::uint8_t* flags) {
  mark_row(darkest, count, live, reference, flags);
}

void divide(const SmoothRow& row, bool all_measured, const std::array<float, 3>& light,
            int first_column, float x_max, int count, std::uint8_t* flags, float* x) {
  if (all_measured && divide_plain_row(row, light, first_column, x_max, count, x)) return;
  divide_row(row, flags, light, first_column, x_max, count, x);
}

void flag_beyond(const float* x, float x_max, int count, std::uint8_t* flags) {
  flag_row(x, x_max, count, flags);
}

void clamp(const float* max_mm, int count, float* depth_mm, std::uint8_t* flags) {
  clamp_row(max_mm, count, depth_mm, flags);
}

}  // namespace alltact::depth_rows
