// Converts between the points A and B on the face and pixels of a frame.
#pragma once

#include "core/sensing/measures.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/inspect/inspected_frame.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// The pixel of a position on the face. A position computed from a pixel gives that pixel again.
/// nullopt: the frame does not show it, or shows no face.
[[nodiscard]] std::optional<cv::Point2d> pixel_of(const InspectedFrame& frame,
                                                  const std::optional<FacePosition>& position);
/// nullopt: the frame has no face.
[[nodiscard]] std::optional<FacePosition> position_of(const InspectedFrame& frame,
                                                      cv::Point2d pixel);

/// Profile between both positions in the compared measurement; nullopt where there is none, or it
/// does not show them.
[[nodiscard]] std::optional<Profile> other_profile(const InspectedFrame& frame,
                                                   const FacePosition& a,
                                                   const FacePosition& b);

/// The pixel with the nearest centre.
[[nodiscard]] cv::Point2d nearest_pixel(cv::Point2d pixel);

}  // namespace alltact
