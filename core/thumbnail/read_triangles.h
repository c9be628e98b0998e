// Reads meshes for viewing: files of write_surface() with their depth, and those of other programs.
#pragma once

#include "core/io/triangles.h"
#include "core/result.h"

#include <filesystem>

namespace alltact {

/// Reads .ply, .vtp and .glb of write_surface() with their depth; other PLY (read_ply.h), STL, OBJ
/// and binary glTF files (through assimp) without: Triangles::depth_mm is empty then. Errors, with
/// the file as `where`: another kind, damaged, no triangles, points that are not finite, more than
/// 4 million triangles, more than 512 MB.
[[nodiscard]] Result<Triangles> read_triangles(const std::filesystem::path& file);

}  // namespace alltact
