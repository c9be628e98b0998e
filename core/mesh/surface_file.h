// Surfaces for other programs.
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Writes a grid of points as a triangle mesh, atomically. Points that are not finite are left out,
/// with their triangles. Triangles face the camera (anticlockwise seen from it). The extension
/// selects the format:
///   .ply  binary; vertices x y z in mm with the property depth_mm
///   .vtp  VTK's XML, appended raw; the same, depth_mm as point data
///   .stl  binary; mm, triangles only, without depth
///   .glb  glTF 2.0 in metres with y up: vertices stay in mm in the camera frame, their node
///         rotates and scales them. Colours are viridis from 0 to the deepest point (0.1 mm at
///         least), which the mesh's extras contain; depth is the attribute _DEPTH_MM
///   points_mm: CV_32FC3; depth_mm: CV_32FC1 of the same size.
/// Errors: those of write_file_atomically; no finite point; another extension.
[[nodiscard]] Status write_surface(const std::filesystem::path& file, const cv::Mat& points_mm,
                                   const cv::Mat& depth_mm);

// A grid of points as triangles.

struct Triangles {
  std::vector<cv::Vec3f> points_mm;
  std::vector<float> depth_mm;                       ///< of every point
  std::vector<std::array<std::int32_t, 3>> corners;  ///< anticlockwise seen from the camera
};

/// Leaves out points that are not finite, and their triangles.
///   points_mm: CV_32FC3; depth_mm: CV_32FC1 of the same size
[[nodiscard]] Triangles triangles_of(const cv::Mat& points_mm, const cv::Mat& depth_mm);

}  // namespace alltact
