// The untouched picture of a flat sensor.
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"

#include <filesystem>

#include <opencv2/core.hpp>

namespace alltact {

/// The untouched picture that the finger names, oriented. Errors: it names none; those of reading
/// it; not of the camera's size.
[[nodiscard]] Result<cv::Mat> flat_reference(const std::filesystem::path& finger_folder,
                                             const Finger& finger);

}  // namespace alltact
