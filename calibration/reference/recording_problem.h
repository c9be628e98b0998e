// What was found in a reference recording, drawn.
#pragma once

#include "calibration/reference/recording_layouts.h"
#include "calibration/reference/recording_pass.h"

#include <string>

#include <opencv2/core.hpp>

namespace alltact {

/// One frame with its face, markers (those not seen where they should be) and the dots that are
/// none: the frame at rest where it was numbered, else the first that shows a face, or anything.
/// Empty when no frame could be read. `numbered`: as far as it came.
/// `sentence`: what is wrong, in English.
[[nodiscard]] cv::Mat recording_problem(const RecordingPass& pass,
                                        const NumberedRecording& numbered,
                                        std::size_t rest,
                                        const std::string& finger_name,
                                        const std::string& sentence);

}  // namespace alltact
