// The untouched picture of a flat sensor.
#pragma once

#include "core/finger/finger_store.h"
#include "core/result.h"

#include <opencv2/core.hpp>

namespace alltact {

/// The untouched picture that the finger names, as frames of this snapshot are (picture_for).
/// Errors: it names none; those of reading it; not of the camera's size.
[[nodiscard]] Result<cv::Mat> flat_reference(const FingerSnapshot& snapshot);

}  // namespace alltact
