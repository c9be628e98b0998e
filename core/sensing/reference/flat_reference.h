// The reference image of a flat sensor.
#pragma once

#include "core/finger/finger_store.h"
#include "core/result.h"

#include <opencv2/core.hpp>

namespace alltact {

/// The reference image that the finger names, converted like frames of this snapshot. Errors: it
/// names none; the file cannot be read; its size is not the camera's.
[[nodiscard]] Result<cv::Mat> flat_reference(const FingerSnapshot& snapshot);

}  // namespace alltact
