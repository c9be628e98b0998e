// Reads meshes for viewing: files of write_surface() with their depth, and those of other programs.
#pragma once

#include "core/base/result.h"
#include "core/mesh/surface_file.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace alltact {

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
