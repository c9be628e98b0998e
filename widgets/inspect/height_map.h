// A measured face as a flat picture in colours.
#pragma once

#include "widgets/inspect/inspect_options.h"
#include "widgets/picture/image_view.h"

namespace alltact {

/// Numbers in colours, CV_8UC4 (premultiplied blue, green, red, alpha), see-through where there is
/// none. -top_mm to top_mm for a difference, else 0 to top_mm.
[[nodiscard]] cv::Mat height_layer(const cv::Mat& value_mm, double top_mm, bool is_difference);

/// Points A and B with their letters, and the line between them.
[[nodiscard]] Overlay points_overlay(const std::optional<cv::Point2d>& a,
                                     const std::optional<cv::Point2d>& b);

/// The scale of the colours, at the lower right of the view.
[[nodiscard]] Overlay height_scale_overlay(double top_mm, bool is_difference, const QString& title);

}  // namespace alltact
