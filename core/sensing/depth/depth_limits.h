// What limits the depth of a pixel or a region.
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
  kLayerLimit = 1,  ///< as deep as the layer is thick: the depth is a lower bound
  kBulgeTop = 2,    ///< bulges by the layer's thickness: minus that is an upper bound of the depth
  kOutOfRange = 4,  ///< deeper than calibrated: extrapolated with the end slope
  kSteep = 8,       ///< the depth changes by more than its sd over one pixel
  kDoubtfulLight = 16  ///< is_light_doubtful(), or light is above 0.02 mm and half of the variance
};
inline constexpr std::uint8_t kDepthClamped = kLayerLimit | kBulgeTop;

/// In files: "layer_limit", "bulge_limit", "out_of_range", "steep", "doubtful_light".
[[nodiscard]] std::vector<std::string_view> limit_names(std::uint8_t limits);

/// kLayerLimit, kBulgeTop or kOutOfRange, from the pixel's flag (PixelFlag).
[[nodiscard]] std::uint8_t limit_of_flag(std::uint8_t flag);

/// True where too little of the face shows the requested light correction. Also true where the
/// light differs from that of the recording by more than kMaxLightChange.
inline constexpr double kMaxLightChange = 0.06;
[[nodiscard]] bool is_light_doubtful(const DepthMap& depth);

/// kSteep and kDoubtfulLight of one depth; `is_doubtful` applies to the full frame.
[[nodiscard]] std::uint8_t limits_of(const DepthErrorTerms& causes, bool is_doubtful);

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
