#include "core/sensing/depth/depth_rows.h"

#include "core/grey_range.h"
#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/depth/pixel_flags.h"
#include "core/sensing/reference/grey_steps.h"

#include <algorithm>
#include <limits>

namespace alltact::depth_rows {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::int16_t kCeiling = kClippedFrom * kGreySteps;

/// Both brightnesses of a row in steps; true when every pixel of it can be measured, as nearly all
/// rows can.
ALLTACT_WIDE bool copy_row(const std::uint8_t* __restrict grey,
                           const std::int16_t* __restrict reference,
                           std::int16_t darkest,
                           int count,
                           std::int16_t* __restrict live_out,
                           std::int16_t* __restrict reference_out) {
  // By place in a block: brought together once, not in every block.
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
          std::int16_t& most = brightest[static_cast<std::size_t>(k)];
          std::int16_t& least = darkest_seen[static_cast<std::size_t>(k)];
          most = brighter > most ? brighter : most;
          least = ref < least ? ref : least;
        }
      });
  return largest_of(brightest) < kCeiling && least_of(darkest_seen) >= darkest;
}

/// Says of each pixel of a row whether it can be measured, and sets both to 0 where not.
ALLTACT_WIDE void mark_row(std::int16_t darkest,
                           int count,
                           std::int16_t* __restrict live,
                           std::int16_t* __restrict reference,
                           std::uint8_t* __restrict flags) {
  constexpr std::int16_t measured = kMeasured, unknown = kNoReference, dark = kTooDark,
                         clipped = kSaturated;
  for (int u = 0; u < count; ++u) {
    const std::int16_t ref = reference[u], now = live[u];
    // The last reason wins; each pixel takes the same steps, so that the loop runs in vectors.
    std::int16_t flag = now >= kCeiling ? clipped : measured;
    flag = ref >= kCeiling ? clipped : flag;
    flag = ref < darkest ? dark : flag;
    flag = ref == kNoGrey ? unknown : flag;
    // A mask: a choice would become a branch.
    const auto kept = static_cast<std::int16_t>(-static_cast<std::int16_t>(flag == measured));
    flags[u] = static_cast<std::uint8_t>(flag);
    live[u] = static_cast<std::int16_t>(now & kept);
    reference[u] = static_cast<std::int16_t>(ref & kept);
  }
}

constexpr float kLeastPart = 0.2F;  // of the kernel: in a corner of the face 0.3 is left

constexpr std::array<float, kBlock> kPlaces = [] {
  std::array<float, kBlock> places{};
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = static_cast<float>(k);
  return places;
}();

/// Divides a row all of whose pixels were measured, as divide_row() does; false where that has to
/// say something of one of them, as in few rows.
ALLTACT_WIDE bool divide_plain_row(const SmoothRow& row,
                                   const std::array<float, 3>& light,
                                   int first_column,
                                   float x_max,
                                   int count,
                                   float* __restrict x) {
  const SmoothRow from = row;
  const float constant = light[0], slope = light[1], bow = light[2];
  std::array<std::int32_t, kBlock> special{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        const auto begin = static_cast<float>(first_column + first);
        for (int k = 0; k < size; ++k) {
          const int u = first + k;
          const float column = begin + kPlaces[static_cast<std::size_t>(k)];
          const float correction = constant + column * (slope + column * bow);
          const auto here = static_cast<float>(from.raw[u]);
          const auto below = static_cast<float>(from.reference[u]);
          const float value = (below - correction * static_cast<float>(from.live[u])) / below;
          x[u] = value;
          const std::int32_t thin = below > kLeastPart * here ? 0 : 1;
          const std::int32_t beyond = value <= x_max ? 0 : 1;
          special[static_cast<std::size_t>(k)] |= thin | beyond;
        }
      });
  return largest_of(special) == 0;
}

/// `light`: what live pixels are to be multiplied with, in powers of u - first_column. Amid pixels
/// that could not be measured hardly any of the kernel is left, and its outer weights are negative:
/// such a pixel takes the reason of those around it, by whether it is nearer to black or to
/// clipped. What is measured and beyond x_max is flagged as such.
ALLTACT_WIDE void divide_row(const SmoothRow& row,
                             std::uint8_t* __restrict flags,
                             const std::array<float, 3>& light,
                             int first_column,
                             float x_max,
                             int count,
                             float* __restrict x) {
  constexpr float measured = kMeasured, clipped = kSaturated, dark = kTooDark,
                  extrapolated = kExtrapolated;
  constexpr float kMiddle = 0.5F * kCeiling;
  const SmoothRow from = row;
  const float constant = light[0], slope = light[1], bow = light[2];
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        const auto begin = static_cast<float>(first_column + first);
        // In three loops: in one the compiler would branch for each pixel.
        std::array<float, kBlock> reason, told;
        for (int k = 0; k < size; ++k) {
          const auto before = static_cast<float>(static_cast<std::int32_t>(flags[first + k]));
          const float flag = before == extrapolated ? measured : before;  // of a place done twice
          const auto here = static_cast<float>(from.raw[first + k]);
          const auto smooth = static_cast<float>(from.reference[first + k]);
          const float thin = here > kMiddle ? clipped : dark;
          const float left = smooth > kLeastPart * here ? measured : thin;
          reason[static_cast<std::size_t>(k)] = flag == measured ? left : flag;
        }
        for (int k = 0; k < size; ++k) {
          const float column = begin + kPlaces[static_cast<std::size_t>(k)];
          const float correction = constant + column * (slope + column * bow);
          const auto live = static_cast<float>(from.live[first + k]);
          const auto smooth = static_cast<float>(from.reference[first + k]);
          const float value = (smooth - correction * live) / smooth;
          told[static_cast<std::size_t>(k)] =
              reason[static_cast<std::size_t>(k)] == measured ? value : kNaN;
        }
        for (int k = 0; k < size; ++k) {
          const float value = told[static_cast<std::size_t>(k)];
          const float final = value > x_max ? extrapolated : reason[static_cast<std::size_t>(k)];
          x[first + k] = value;
          flags[first + k] = static_cast<std::uint8_t>(static_cast<std::int32_t>(final));
        }
      });
}

ALLTACT_WIDE void flag_row(const float* __restrict x,
                           float x_max,
                           int count,
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

ALLTACT_WIDE void bound_row(const float* __restrict most_mm,
                            int count,
                            float* __restrict depth_mm,
                            std::uint8_t* __restrict flags) {
  std::array<std::int32_t, kBlock> deeper{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        for (int k = 0; k < size; ++k)
          deeper[static_cast<std::size_t>(k)] |=
              std::abs(depth_mm[first + k]) > most_mm[first + k] ? 1 : 0;
      });
  if (largest_of(deeper) == 0) return;  // as nearly everywhere
  for (int u = 0; u < count; ++u) {
    const float most = most_mm[u];
    if (!(std::abs(depth_mm[u]) > most)) continue;
    flags[u] = depth_mm[u] > 0.0F ? kBeyondLayer : kBulgeLimit;
    depth_mm[u] = std::copysign(most, depth_mm[u]);
  }
}

}  // namespace

bool copy(const std::uint8_t* grey,
          const std::int16_t* reference,
          std::int16_t darkest,
          int count,
          std::int16_t* live_out,
          std::int16_t* reference_out) {
  return copy_row(grey, reference, darkest, count, live_out, reference_out);
}

void mark(std::int16_t darkest,
          int count,
          std::int16_t* live,
          std::int16_t* reference,
          std::uint8_t* flags) {
  mark_row(darkest, count, live, reference, flags);
}

void divide(const SmoothRow& row,
            bool all_measured,
            const std::array<float, 3>& light,
            int first_column,
            float x_max,
            int count,
            std::uint8_t* flags,
            float* x) {
  if (all_measured && divide_plain_row(row, light, first_column, x_max, count, x)) return;
  divide_row(row, flags, light, first_column, x_max, count, x);
}

void flag_beyond(const float* x, float x_max, int count, std::uint8_t* flags) {
  flag_row(x, x_max, count, flags);
}

void bound(const float* most_mm, int count, float* depth_mm, std::uint8_t* flags) {
  bound_row(most_mm, count, depth_mm, flags);
}

}  // namespace alltact::depth_rows
