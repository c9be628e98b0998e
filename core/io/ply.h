// Surfaces for other programs.
#pragma once

#include "core/result.h"

#include <filesystem>

#include <opencv2/core.hpp>

namespace alltact {

/// Writes a grid of points as a triangle mesh: binary little-endian PLY, vertices x y z in mm with
/// the property depth_mm, whole or not at all. Points that are not finite are left out, with the
/// triangles they would belong to. Triangles face the camera (anticlockwise seen from it).
///   points_mm: CV_32FC3; depth_mm: CV_32FC1 of the same size.
/// Errors: those of write_file_atomically; no finite point.
[[nodiscard]] Status write_ply(const std::filesystem::path& file,
                               const cv::Mat& points_mm,
                               const cv::Mat& depth_mm);

}  // namespace alltact
