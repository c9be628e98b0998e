// How sure every pixel's depth is.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/face_shape.h"
#include "core/sensing/local_depth.h"
#include "core/sensing/reference_library.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Standard deviation of every pixel's depth, CV_32FC1, mm along z, NaN where there is no depth.
/// Two parts, independent of each other: noise of the picture and of its reference,
///   f M'(x) sd / I_ref * sqrt(1 + (1 - x)^2 gain^2),
/// and what the calibration leaves open of the mapping (Mapping::depth_sd_mm at the pixel's place).
/// What a reference of another pose or a change of the light may be off by is not in it. Not made
/// for every live frame: as dear as the depth itself.
[[nodiscard]] cv::Mat depth_sd_mm(const DepthMap& depth,
                                  const Reference& reference,
                                  const FaceShape& shape,
                                  const Mapping& mapping);

}  // namespace alltact
