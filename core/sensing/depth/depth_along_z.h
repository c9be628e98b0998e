// Depth measured along the layer's normal, told along z.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Where brightness follows the layer's thickness along its normal, a pixel with the view point p
/// sees the pressed face at p + n (layer - d_n). The depth map, though, tells how far the pressed
/// face lies before the untouched one on the line through p along z: a place that another pixel
/// sees, up to a layer's thickness away on an inclined face. This turns the one into the other by
/// looking up, for every pixel, which other pixel sees its line (a few fixed-point steps along the
/// finger, since the normal has no part across it).
///
/// depth_normal_mm: CV_32FC1, NaN where not measured; cells_mm: its means (depth_cells.h), which
/// say where looking is worth it. The result has the size and type of depth_normal_mm and
/// is NaN where that is. Bulges (depth < 0) are turned alike. What a pixel looked up is flagged
/// (CV_8UC1 of PixelFlag) as where it was found, so that a depth at a limit keeps its mark.
[[nodiscard]] cv::Mat depth_along_z(const cv::Mat& depth_normal_mm,
                                    const cv::Mat& cells_mm,
                                    const FaceShape& shape,
                                    cv::Mat& flags);

}  // namespace alltact
