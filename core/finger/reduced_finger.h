// A finger at reduced image resolution.
#pragma once

#include "core/finger/finger_store.h"

namespace alltact {

/// Converts all pixel coordinates (camera, markers at rest, positions for poses) to images that are
/// reduced by `by` pixels a side (reduced_image.h). Returns the finger unchanged where `by` is 1,
/// it is reduced already, or its images would be smaller than any camera's (16 px).
[[nodiscard]] FingerSnapshot reduced_finger(const FingerSnapshot& finger, int by);

/// A raw image in the orientation of the finger's camera, reduced like the finger. Error: its size
/// differs from the finger's camera, see oriented_for().
[[nodiscard]] Result<cv::Mat> image_for(const FingerSnapshot& finger,
                                        const cv::Mat& raw,
                                        const Message& what,
                                        const Where& where,
                                        const Message& advice);

}  // namespace alltact
