// Reader for triangle meshes of other programs.
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <Eigen/Core>
#include <assimp/Importer.hpp>

namespace alltact {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;  ///< without duplicates; in the file's unit
  std::vector<std::array<int, 3>> triangles;
};

inline constexpr std::uintmax_t kMaxMeshBytes = std::uintmax_t{512} << 20;

/// Reads STL or OBJ (by the extension), all objects of the file as one. Errors, with the file as
/// `where`: another format, no triangles, more than 4 million of them, points that are not finite,
/// more than 512 MB.
[[nodiscard]] Result<TriangleMesh> read_mesh(const std::filesystem::path& file);

/// Error: the mesh does not enclose a body, because an edge does not border exactly two triangles.
[[nodiscard]] Status check_closed(const TriangleMesh& mesh);

// Conversion of other programs' meshes to triangles, by assimp.

/// The imported and validated scene as triangles, transformed by their nodes. nullptr: nothing was
/// imported, or a face has no corners, for which assimp would end the program.
[[nodiscard]] const aiScene* scene_triangles(Assimp::Importer& importer);

}  // namespace alltact
