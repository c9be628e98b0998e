// Overlays with the measurement of each pixel: CV_8UC4, premultiplied blue, green, red, alpha.
#pragma once

#include "core/sensing/pipeline.h"

#include <opencv2/core.hpp>

namespace alltact {

/// An overlay that is stored only where it shows something.
struct PartLayer {
  cv::Mat pixels;  ///< empty: nowhere
  cv::Point at;    ///< of its first pixel, in the oriented image
};

/// The depth map in colours (depth_colour), more transparent at small depths and bulges.
[[nodiscard]] PartLayer depth_layer(const DepthMap& depth, double top_mm);
/// Stripes falling to the right where a pixel is flagged kSaturated, to the left where kTooDark,
/// level and white where the depth is at a limit (is_at_limit). Without a measurement `grey` alone
/// decides both (grey_range.h), on the face only, where that is known. Size: the oriented image's.
/// `grey`: CV_8UC1, the result's.
[[nodiscard]] cv::Mat faults_layer(const cv::Mat& grey, const FrameResult& result);

}  // namespace alltact
