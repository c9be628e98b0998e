// Converts depth along the layer's normal to depth along z.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Where brightness follows the layer's thickness along its normal, a pixel with the view point p
/// sees the pressed face at p + n (layer - d_n). The depth map holds the distance along z between
/// the contact-free and the pressed face on the line through p. Another pixel sees that point, up
/// to a layer's thickness away on an inclined face. For every pixel this finds the pixel that sees
/// its line, by a few fixed-point steps along the finger. The normal has no component across the
/// finger.
///
/// depth_normal_mm: CV_32FC1, NaN where not measured. cells_mm: its means (depth_cells.h), which
/// select the pixels to look up. The result has the size and type of depth_normal_mm and is NaN
/// where that is. Bulges (depth < 0) are converted alike. A converted pixel takes the flag (CV_8UC1
/// of PixelFlag) of the pixel that sees its line.
[[nodiscard]] cv::Mat depth_along_z(const cv::Mat& depth_normal_mm,
                                    const cv::Mat& cells_mm,
                                    const FaceShape& shape,
                                    cv::Mat& flags);

}  // namespace alltact
