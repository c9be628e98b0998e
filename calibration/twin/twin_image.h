// Rendered images of a twin. All of them come from here.
#pragma once

#include "calibration/twin/twin_scene.h"
#include "core/result.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Frame `frame` without noise, CV_32FC1. Errors: those of Scene::parse and Plan::compile.
[[nodiscard]] Result<cv::Mat> twin_image(const TwinScene& scene, int frame);

/// The camera that sees a part of another's image.
[[nodiscard]] CameraParameters cropped_camera(const CameraParameters& camera, const cv::Rect& part);
/// The camera whose pixels are means over complete blocks of `side` x `side` pixels of another's.
[[nodiscard]] CameraParameters downsampled_camera(const CameraParameters& camera, int side);
/// Those means of a CV_32FC1 image; NaN where any of the pixels is NaN.
[[nodiscard]] cv::Mat downsampled_image(const cv::Mat& grey, int side);

}  // namespace alltact
