// Reader for triangle meshes of other programs.
#pragma once

#include "core/result.h"

#include <array>
#include <filesystem>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> points;  ///< without duplicates; in the file's unit
  std::vector<std::array<int, 3>> triangles;
};

/// Reads STL or OBJ (by the extension), all objects of the file as one. Errors, with the file as
/// `where`: another format, no triangles, more than 4 million of them, points that are not finite,
/// more than 512 MB.
[[nodiscard]] Result<TriangleMesh> read_mesh(const std::filesystem::path& file);

/// Error: the mesh does not enclose a body, because an edge does not border exactly two triangles.
[[nodiscard]] Status check_closed(const TriangleMesh& mesh);

}  // namespace alltact
