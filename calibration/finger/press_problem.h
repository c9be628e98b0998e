// An image of the presses that a calibration could not use.
#pragma once

#include "calibration/finger/calibrate_finger.h"

#include <filesystem>
#include <string>

#include <opencv2/core.hpp>

namespace alltact {

inline constexpr const char* kPressProblem = "calibration.problem.png";

/// The presses that were left out, one below the other (problem_image.h), each with its reason;
/// eight at most, without those that a person excluded. `refused`: why there is no calibration at
/// all, in English; presses without a reason of their own are then shown as well. Empty where there
/// is nothing to show.
[[nodiscard]] cv::Mat press_problem(const FingerCalibration& done, const std::string& refused);

/// Writes that image into the finger's folder, or removes that of an earlier calibration. Returns
/// its path; empty where there is none.
std::filesystem::path leave_press_problem(const std::filesystem::path& finger_folder,
                                          const FingerCalibration& done,
                                          const std::string& refused);

}  // namespace alltact
