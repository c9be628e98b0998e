// Images of reduced resolution, each pixel the mean of several, and their camera model.
#pragma once

#include "core/camera/camera.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Converts a coordinate of the full image to the reduced one. The centre of reduced pixel 0 is the
/// mean of those of pixels 0 to by - 1.
[[nodiscard]] constexpr double reduced_px(double full_px, int by) {
  return (full_px + 0.5) / by - 0.5;
}
/// The inverse of reduced_px().
[[nodiscard]] constexpr double full_px(double reduced_px, int by) {
  return (reduced_px + 0.5) * by - 0.5;
}

/// CV_8UC1: each pixel the mean of by x by, rounded. Incomplete squares at the far ends are left
/// out. by: 1 (no copy) or more.
[[nodiscard]] cv::Mat reduced_image(const cv::Mat& grey, int by);

/// The camera of such images: the same rays, in pixels of the reduced image.
[[nodiscard]] CameraParameters reduced_camera(const CameraParameters& camera, int by);

}  // namespace alltact
