// The problem of a reference recording as an image.
#pragma once

#include "calibration/reference/make_reference.h"
#include "calibration/reference/recording_pass.h"

#include <string>

#include <opencv2/core.hpp>

namespace alltact {

/// One frame with its face, markers (missing ones at their expected positions) and rejected dots.
/// With a contact: the frame in which it is darkest, and its position. Else the rest frame where it
/// was numbered, or the first frame with a face, or any. Empty when no frame could be read. `made`:
/// may be partly filled. `sentence`: the problem, in English.
[[nodiscard]] cv::Mat recording_problem(const RecordingPass& pass,
                                        const MadeReference& made,
                                        const Camera& camera,
                                        const Finger& finger,
                                        const std::string& sentence);

}  // namespace alltact
