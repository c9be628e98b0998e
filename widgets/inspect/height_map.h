// A measured face as a flat picture in colours.
#pragma once

#include "core/io/colour_map.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/picture/overlays.h"

#include <vector>

namespace alltact {

/// Numbers in colours, CV_8UC4 (premultiplied blue, green, red, alpha), see-through where there is
/// none.
[[nodiscard]] cv::Mat height_layer(const cv::Mat& value_mm, const ColourScale& scale);

/// Patterns where a depth is limited (DepthLimit bits, CV_8UC1), CV_8UC4 as above: white stripes at
/// the layer's limit, black ones beyond what was calibrated, orange dots in doubtful light, small
/// white ones where it is steep. Empty where nothing is.
[[nodiscard]] cv::Mat limits_layer(const cv::Mat& limits);
/// What the patterns mean, of those that show on at least 30 pixels.
[[nodiscard]] std::vector<LegendLine> limits_legend(const cv::Mat& limits);

/// Points A and B with their letters, the line between them, and the box whose corners
/// they are.
[[nodiscard]] Overlay points_overlay(const std::optional<cv::Point2d>& a,
                                     const std::optional<cv::Point2d>& b);

}  // namespace alltact
