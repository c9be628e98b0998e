// A measured face as a flat picture in colours.
#pragma once

#include "core/io/colour_map.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/picture/image_view.h"

namespace alltact {

/// Numbers in colours, CV_8UC4 (premultiplied blue, green, red, alpha), see-through where there is
/// none.
[[nodiscard]] cv::Mat height_layer(const cv::Mat& value_mm, const ColourScale& scale);

/// Points A and B with their letters, the line between them, and the box whose corners
/// they are.
[[nodiscard]] Overlay points_overlay(const std::optional<cv::Point2d>& a,
                                     const std::optional<cv::Point2d>& b);

}  // namespace alltact
