// Reasons why the depth of a pixel is missing or doubtful.
#pragma once

#include "core/sensing/reference/hidden_ends.h"

#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Why a pixel has no depth, or a doubtful one. 0: measured.
enum PixelFlag : std::uint8_t {
  kMeasured = 0,
  kOffFace = 1,       ///< no face here: NaN
  kTooDark = 2,       ///< the reference is too dark to divide by (grey_range.h): NaN
  kSaturated = 3,     ///< live or reference image is clipped (grey_range.h): NaN
  kExtrapolated = 4,  ///< darker than anything calibrated: extrapolated with the end slope
  kBeyondLayer = 5,   ///< deeper than the layer is thick: set to the thickness
  kNoReference = 6,   ///< the recording does not show this part of the face in this pose: NaN
  kHiddenEnd = 7,     ///< the face continues here, but something hides its end: NaN
  kBulgeLimit = 8,    ///< bulges by more than the layer is thick: set to minus the thickness
};
constexpr std::size_t kPixelFlagCount = 9;  ///< number of flags

/// Whether the depth is only a lower bound (kBeyondLayer) or an upper bound (kBulgeLimit).
[[nodiscard]] constexpr bool is_at_limit(std::uint8_t flag) {
  return flag == kBeyondLayer || flag == kBulgeLimit;
}

/// Fractions of the face by flag, over the pixels that are not kOffFace, from one in `every_row`
/// rows. All 0 where there is no face.
struct FlagFractions {
  std::array<double, kPixelFlagCount> of;  ///< by PixelFlag
};
[[nodiscard]] FlagFractions flag_fractions(const cv::Mat& flags, int every_row = 1);

/// Sets kHiddenEnd in these columns where the flag is kOffFace. flags: CV_8UC1 of PixelFlag.
void flag_hidden(const std::vector<HiddenColumn>& columns, cv::Mat* flags);

}  // namespace alltact
