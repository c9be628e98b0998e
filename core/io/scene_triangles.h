// Meshes of other programs as triangles, by assimp.
#pragma once

#include <assimp/Importer.hpp>

namespace alltact {

/// What `importer` has read and validated, cut into triangles that lie where their nodes put them;
/// nullptr where it has read nothing, or a face without corners: at that assimp would end the
/// program.
[[nodiscard]] const aiScene* scene_triangles(Assimp::Importer& importer);

}  // namespace alltact
