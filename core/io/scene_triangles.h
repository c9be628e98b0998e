// Conversion of other programs' meshes to triangles, by assimp.
#pragma once

#include <assimp/Importer.hpp>

namespace alltact {

/// The imported and validated scene as triangles, transformed by their nodes. nullptr: nothing was
/// imported, or a face has no corners, for which assimp would end the program.
[[nodiscard]] const aiScene* scene_triangles(Assimp::Importer& importer);

}  // namespace alltact
