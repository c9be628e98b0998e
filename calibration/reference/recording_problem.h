// What was found in a reference recording, drawn.
#pragma once

#include "calibration/reference/make_reference.h"
#include "calibration/reference/recording_pass.h"

#include <string>

#include <opencv2/core.hpp>

namespace alltact {

/// One frame with its face, markers (those not seen where they should be) and the dots that are
/// none. Where something pressed, the frame in which that is darkest and its place; else the frame
/// at rest where it was numbered, or the first that shows a face, or anything. Empty when no frame
/// could be read. `made`: as far as it came. `sentence`: what is wrong, in English.
[[nodiscard]] cv::Mat recording_problem(const RecordingPass& pass,
                                        const MadeReference& made,
                                        const Camera& camera,
                                        const Finger& finger,
                                        const std::string& sentence);

}  // namespace alltact
