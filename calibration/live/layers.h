// What the measurement says of each pixel, as pictures to lay over the frame. Each is CV_8UC4,
// premultiplied blue, green, red, alpha, the oriented picture's size.
#pragma once

#include "core/sensing/pipeline.h"

#include <opencv2/core.hpp>

namespace alltact {

/// The depth map in colours (viridis), more see-through where little presses.
[[nodiscard]] cv::Mat depth_layer(const DepthMap& depth, double top_mm);
/// Stripes falling to the right where the measurement flags a pixel as kSaturated, to the left
/// where as kTooDark. Where nothing was measured, `grey` alone tells both (grey_range.h), on the
/// face only, where that is known. `grey`: CV_8UC1, the result's.
[[nodiscard]] cv::Mat faults_layer(const cv::Mat& grey, const FrameResult& result);

}  // namespace alltact
