// Maps over the face with axes in millimetres: rows across, columns along.
#pragma once

#include "core/image/image_file.h"
#include "core/sensing/face/face_shape.h"

#include <opencv2/core.hpp>

namespace alltact {

struct RectifiedMap {
  cv::Mat values;       ///< CV_32FC1, NaN where nothing is measured
  PixelsOnPlane plane;  ///< columns along the face from its base, rows across from its middle line
};

/// A map by pixels (CV_32FC1, of the shape's image) at positions on the face
/// (FaceShape::position_mm) in round steps, by bilinear interpolation. Empty off the face.
[[nodiscard]] RectifiedMap rectified_map(const cv::Mat& by_pixel, const FaceShape& shape,
                                         double step_mm = 0.1);

}  // namespace alltact
