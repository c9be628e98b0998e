// A measured face as a colour-coded height map.
#pragma once

#include "core/io/colour_map.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/inspect_options.h"

#include <vector>

namespace alltact {

/// Values as colours, CV_8UC4 (premultiplied blue, green, red, alpha), transparent where there is
/// none.
[[nodiscard]] cv::Mat height_layer(const cv::Mat& value_mm, const ColourScale& scale);

/// Patterns where a depth is limited (DepthLimit bits, CV_8UC1), CV_8UC4 as above. White stripes:
/// at the layer's limit; black stripes: outside the calibrated range; orange dots: doubtful light;
/// small white dots: steep. Empty where no pixel is limited.
[[nodiscard]] cv::Mat limits_layer(const cv::Mat& limits);
/// Legend of the patterns that cover at least 30 pixels.
[[nodiscard]] std::vector<LegendLine> limits_legend(const cv::Mat& limits);

/// Points A and B with their letters, the line between them, and the box whose corners they are.
[[nodiscard]] Overlay points_overlay(const std::optional<cv::Point2d>& a,
                                     const std::optional<cv::Point2d>& b);

}  // namespace alltact
