// What the simulator makes of a twin: the only renderer there is here.
#pragma once

#include "calibration/twin/twin_scene.h"
#include "core/result.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Frame `frame` without noise, CV_32FC1. Errors: those of Scene::parse and Plan::compile.
[[nodiscard]] Result<cv::Mat> twin_picture(const TwinScene& scene, int frame);

/// The camera that sees a part of another's picture.
[[nodiscard]] CameraParameters cropped_camera(const CameraParameters& camera, const cv::Rect& part);
/// The camera whose pixels are the means over `side` x `side` pixels of another's, whole ones only.
[[nodiscard]] CameraParameters thinned_camera(const CameraParameters& camera, int side);
/// Those means of a CV_32FC1 picture; NaN where any of the pixels is.
[[nodiscard]] cv::Mat thinned_picture(const cv::Mat& grey, int side);

}  // namespace alltact
