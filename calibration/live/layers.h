// What the measurement says of each pixel, as pictures to lay over the frame: CV_8UC4,
// premultiplied blue, green, red, alpha.
#pragma once

#include "core/sensing/pipeline.h"

#include <opencv2/core.hpp>

namespace alltact {

/// A layer of which nothing is kept but where it shows something.
struct PartLayer {
  cv::Mat pixels;  ///< empty: nowhere
  cv::Point at;    ///< of its first pixel, in the oriented picture
};

/// The depth map in colours (depth_colour), more see-through where little presses or bulges.
[[nodiscard]] PartLayer depth_layer(const DepthMap& depth, double top_mm);
/// Stripes falling to the right where the measurement flags a pixel as kSaturated, to the left
/// where as kTooDark, level and white where the depth is at a limit (is_at_limit). Where nothing
/// was measured, `grey` alone tells both (grey_range.h), on the face only, where that is known. Of
/// the oriented picture's size. `grey`: CV_8UC1, the result's.
[[nodiscard]] cv::Mat faults_layer(const cv::Mat& grey, const FrameResult& result);

}  // namespace alltact
