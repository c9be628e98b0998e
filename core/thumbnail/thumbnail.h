// Thumbnails of depth maps and meshes, as a file manager shows them.
#pragma once

#include "core/base/result.h"
#include "core/mesh/surface_file.h"

#include <filesystem>
#include <optional>
#include <string_view>

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

/// Of a file by its name: NAME.depth.tiff, NAME.depth16.png, or a mesh (read_triangles()). Errors:
/// those of reading them; a name of neither kind.
[[nodiscard]] Result<cv::Mat> thumbnail_of(const std::filesystem::path& file, int size_px);

// Reading of meshes for viewing: files of write_surface() with their depth, and those of other
// programs.

/// Reads .ply, .vtp and .glb of write_surface() with their depth; other PLY, STL, OBJ
/// and binary glTF files (through assimp) without: Triangles::depth_mm is empty then. Errors, with
/// the file as `where`: another kind, damaged, no triangles, points that are not finite, more than
/// 4 million triangles, more than 512 MB.
[[nodiscard]] Result<Triangles> read_triangles(const std::filesystem::path& file);

// Reads PLY meshes of any program.

/// PLY (Turk, "The PLY polygon file format", 1994), as text or binary of either byte order. Of the
/// element `vertex` it reads x, y, z and, if present, depth_mm; of `face` the polygons. Each is cut
/// into triangles around its first corner (right for convex ones). Everything else is ignored.
/// Reading ends after the first face beyond `max_triangles`, so the result then holds more than
/// that. nullopt: an invalid header; data shorter than the header announces; a polygon with more
/// than 2^20 corners; more than 3 `max_triangles` points. Corners and coordinates are returned as
/// in the file: the caller checks that corners are in range and points finite.
[[nodiscard]] std::optional<Triangles> read_ply(std::string_view bytes, std::size_t max_triangles);

}  // namespace alltact
