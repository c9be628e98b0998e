// A picture of the presses that a calibration could not use.
#pragma once

#include "calibration/finger/calibrate_finger.h"

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace alltact {

inline constexpr const char* kPressProblem = "calibration.problem.png";

/// Below each other (problem_picture.h) the presses that were left out, each with its reason, but
/// not those that somebody excluded; eight at most. `refused`: why there is no calibration at all,
/// in English, empty where there is one: then presses without a reason of their own are shown as
/// well. Empty where there is nothing to show.
[[nodiscard]] cv::Mat press_problem(const FingerCalibration& done, const std::string& refused);

/// Writes that picture into the finger's folder, or removes that of an earlier calibration. Where
/// it lies; empty where there is none.
std::filesystem::path leave_press_problem(const std::filesystem::path& finger_folder,
                                          const FingerCalibration& done,
                                          const std::string& refused);

}  // namespace alltact
