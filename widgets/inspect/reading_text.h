// What was measured at two points, in words.
#pragma once

#include "widgets/inspect/inspected_frame.h"

#include <QString>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Rich text: places of A and B with depth and its standard deviation, and how far they are apart.
[[nodiscard]] QString reading_text(const InspectedFrame& frame,
                                   const std::optional<cv::Point2d>& a,
                                   const std::optional<cv::Point2d>& b);

/// "Deepest 0.82 mm at x 3.1, y -0.2, z 48.0 mm."; empty where nothing presses.
[[nodiscard]] QString deepest_text(const InspectedFrame& frame);

}  // namespace alltact
