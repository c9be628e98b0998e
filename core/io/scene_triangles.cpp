#include "core/io/scene_triangles.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace alltact {

const aiScene* scene_triangles(Assimp::Importer& importer) {
  const aiScene* scene = importer.GetScene();
  if (scene == nullptr) return nullptr;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& mesh = *scene->mMeshes[i];
    for (unsigned k = 0; k < mesh.mNumFaces; ++k)
      if (mesh.mFaces[k].mNumIndices == 0) return nullptr;
  }
  return importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_PreTransformVertices);
}

}  // namespace alltact
