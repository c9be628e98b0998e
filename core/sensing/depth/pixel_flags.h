// What the depth of each pixel is worth.
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
  kSaturated = 3,     ///< live or reference picture is clipped (grey_range.h): NaN
  kExtrapolated = 4,  ///< darker than anything calibrated: depth goes on with the end slope
  kBeyondLayer = 5,   ///< deeper than the layer is thick: depth is set to that
  kNoReference = 6,   ///< the recording does not show this part of the face in this pose: NaN
  kHiddenEnd = 7,     ///< the face goes on here, but something hides its end: NaN
  kBulgeLimit = 8,    ///< bulges by more than the layer is thick: depth is set to minus that
};
constexpr std::size_t kPixelFlags = 9;  ///< how many there are

/// Whether the depth is only a least value (kBeyondLayer) or a greatest one (kBulgeLimit).
[[nodiscard]] constexpr bool is_at_limit(std::uint8_t flag) {
  return flag == kBeyondLayer || flag == kBulgeLimit;
}

/// Parts of the face by what their depth is worth: those of the pixels that are not kOffFace, told
/// from one in `every_row` rows. All 0 where there is no face.
struct FlagShares {
  std::array<double, kPixelFlags> of;  ///< by PixelFlag
};
[[nodiscard]] FlagShares flag_shares(const cv::Mat& flags, int every_row = 1);

/// kOffFace becomes kHiddenEnd there. flags: CV_8UC1 of PixelFlag.
void flag_hidden(const std::vector<HiddenColumn>& columns, cv::Mat* flags);

}  // namespace alltact
