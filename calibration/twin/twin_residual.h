// Difference between a twin's image of a press and the real one.
#pragma once

#include "calibration/twin/twin.h"

#include <opencv2/core.hpp>

namespace alltact {

/// `twin`, `twin_untouched`: CV_32FC1, of the press and of the untouched finger in its pose;
/// `middle_px`: of the contact.
[[nodiscard]] TwinResidual residual_of(const TwinPress& press,
                                       const cv::Mat& twin,
                                       const cv::Mat& twin_untouched,
                                       const Eigen::Vector2d& middle_px);

}  // namespace alltact
