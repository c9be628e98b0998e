// Thumbnails of depth maps and meshes, as a file manager shows them.
#pragma once

#include "core/base/result.h"
#include "core/mesh/surface_file.h"

#include <filesystem>

#include <opencv2/core.hpp>

namespace alltact {

/// Depth in colours (viridis, from 0 to the maximum, 0.1 mm at least), transparent where there is
/// none.
///   depth_mm: CV_32FC1, NaN where there is none
///   size_px: of the longer side, 1 to 4096; the other follows the aspect ratio
/// Gives CV_8UC4: blue, green, red, opacity.
[[nodiscard]] cv::Mat depth_thumbnail(const cv::Mat& depth_mm, int size_px);

/// A mesh, lit from the upper left and viewed at 40 degrees from its flattest direction, its
/// longest direction horizontal; in the colours of its depth if it has any. A software renderer: it
/// needs no graphics card, display or window library, and its bytes are the same everywhere.
///   triangles: at least one, all of finite points
/// Gives CV_8UC4, size_px square.
[[nodiscard]] cv::Mat mesh_thumbnail(const Triangles& triangles, int size_px);

/// Of a file by its name: NAME.depth.tiff, NAME.depth16.png, or a mesh (read_triangles.h). Errors:
/// those of reading them; a name of neither kind.
[[nodiscard]] Result<cv::Mat> thumbnail_of(const std::filesystem::path& file, int size_px);

}  // namespace alltact
