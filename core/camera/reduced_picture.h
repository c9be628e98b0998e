// Pictures of fewer pixels, each the mean of several, and the camera that would give them.
#pragma once

#include "core/camera/camera.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Where a place of the whole picture lies in the reduced one: pixel 0's centre is that of the mean
/// of pixels 0 to by - 1.
[[nodiscard]] constexpr double reduced_px(double whole_px, int by) {
  return (whole_px + 0.5) / by - 0.5;
}
/// The way back.
[[nodiscard]] constexpr double whole_px(double reduced_px, int by) {
  return (reduced_px + 0.5) * by - 0.5;
}

/// CV_8UC1: every pixel the mean of by x by, rounded; rows and columns that fill no such square at
/// the far ends are left out. by: 1 (no copy) or more.
[[nodiscard]] cv::Mat reduced_picture(const cv::Mat& grey, int by);

/// The camera of such pictures: the same rays, at places of the reduced picture.
[[nodiscard]] CameraParameters reduced_camera(const CameraParameters& camera, int by);

}  // namespace alltact
