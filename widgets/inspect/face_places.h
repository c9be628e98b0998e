// The points A and B in the picture of a frame, and back.
#pragma once

#include "core/sensing/measures.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Where a place of the face lies in the frame's picture; a place that was told of a pixel is that
/// pixel again. nullopt: this frame does not show it, or no face.
[[nodiscard]] std::optional<cv::Point2d> pixel_of(const InspectedFrame& frame,
                                                  const std::optional<FacePlace>& place);
/// nullopt: the frame has no face.
[[nodiscard]] std::optional<FacePlace> place_of(const InspectedFrame& frame, cv::Point2d pixel);

/// Along the line between the places in what the frame is compared with; nullopt where there is no
/// such, or it does not show them.
[[nodiscard]] std::optional<Profile> other_profile(const InspectedFrame& frame,
                                                   const FacePlace& a,
                                                   const FacePlace& b);

/// The pixel whose middle is nearest.
[[nodiscard]] cv::Point2d whole_pixel(cv::Point2d pixel);

}  // namespace alltact
