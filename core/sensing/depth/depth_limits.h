// What limits the depth of a pixel or a region: where the number is less than it looks.
#pragma once

#include "core/sensing/depth/depth_sd.h"

#include <cstdint>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Bits of one byte.
enum DepthLimit : std::uint8_t {
  kNoLimit = 0,
  kLayerLimit = 1,     ///< as deep as the layer is thick: the depth is at least that
  kBulgeTop = 2,       ///< bulges by the layer's thickness: the depth is at most minus that
  kOutOfRange = 4,     ///< deeper than calibrated: read from the straight line beyond the curve
  kSteep = 8,          ///< a pixel of misplacement changes the depth by more than its sd
  kDoubtfulLight = 16  ///< is_light_doubtful(), or more than 0.02 mm and half the variance is light
};
inline constexpr std::uint8_t kAnyEnd = kLayerLimit | kBulgeTop;

/// In files: "layer_limit", "bulge_limit", "out_of_range", "steep", "doubtful_light".
[[nodiscard]] std::vector<std::string_view> limit_names(std::uint8_t limits);

/// kLayerLimit, kBulgeTop or kOutOfRange, from the pixel's flag (PixelFlag).
[[nodiscard]] std::uint8_t limit_of_flag(std::uint8_t flag);

/// The light that `depth` was corrected for: it was wanted and too little of the face tells it, or
/// it is brighter or darker than when the reference was recorded by more than kLightOffPart.
inline constexpr double kLightOffPart = 0.06;
[[nodiscard]] bool is_light_doubtful(const DepthMap& depth);

/// kSteep and kDoubtfulLight of one depth; `is_doubtful` of the whole frame.
[[nodiscard]] std::uint8_t limits_of(const DepthCauses& causes, bool is_doubtful);

/// Standard deviation (depth_sd_mm) and limits of every pixel in one pass: CV_32FC1, mm, and
/// CV_8UC1 of DepthLimit bits, 0 where there is no depth.
struct DepthSdAndLimits {
  cv::Mat sd_mm, limits;
};
[[nodiscard]] DepthSdAndLimits depth_sd_and_limits(const DepthMap& depth,
                                                   const Reference& reference,
                                                   const FaceShape& shape,
                                                   const Mapping& mapping);

}  // namespace alltact
