#include "core/mesh/mesh_file.h"

#include "core/base/letters.h"
#include "core/base/message.h"

#include <algorithm>
#include <map>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

namespace alltact {
namespace {

constexpr std::size_t kMaxTriangles = 4'000'000;

// Merges corners of different triangles at one position into one point.
class UniquePoints {
 public:
  explicit UniquePoints(TriangleMesh& mesh) : mesh_(mesh) {}
  int number_of(const aiVector3D& at) {
    // -0 and 0 are one position.
    const std::array<float, 3> key{at.x + 0.0F, at.y + 0.0F, at.z + 0.0F};
    const auto [known, is_new] = numbers_.emplace(key, static_cast<int>(mesh_.points.size()));
    if (is_new) mesh_.points.emplace_back(at.x, at.y, at.z);
    return known->second;
  }

 private:
  TriangleMesh& mesh_;
  std::map<std::array<float, 3>, int> numbers_;
};

Status take(const aiMesh& part, TriangleMesh& mesh, UniquePoints& points) {
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& at = part.mVertices[i];
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
      return Error{en::say("a point of the mesh is not a number"), "", en::say("export it again")};
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines
    std::array<int, 3> triangle{};
    for (unsigned k = 0; k < 3; ++k)
      triangle[k] = points.number_of(part.mVertices[face.mIndices[k]]);
    const auto [a, b, c] = triangle;
    if (a != b && b != c && c != a) mesh.triangles.push_back(triangle);
  }
  return {};
}

}  // namespace

Result<TriangleMesh> read_mesh(const std::filesystem::path& file) {
  const auto refuse = [&](Message what, Message advice) {
    return Error{std::move(what), file.string(), std::move(advice)};
  };
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(file, failed);
  if (failed) return refuse(en::say("the mesh does not exist"), en::say("an STL or OBJ file"));
  const std::string kind = lowered_extension(file);
  if (kind != ".stl" && kind != ".obj")
    return refuse(en::say("this mesh format is unknown"),
                  en::say("a file that ends in .stl or .obj"));
  if (size > kMaxMeshBytes)
    return refuse(en::say("the mesh's file is larger than 512 MB"),
                  en::say("export a coarser mesh"));
  Assimp::Importer importer;
  importer.ReadFile(file.string(), aiProcess_ValidateDataStructure);
  const aiScene* scene = scene_triangles(importer);
  if (!scene)
    return refuse(en::say("the mesh cannot be read"),
                  en::say("export it again, e.g. as binary STL"));
  TriangleMesh mesh;
  UniquePoints points(mesh);
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    if (const Status status = take(*scene->mMeshes[i], mesh, points); !status)
      return refuse(status.error().what, status.error().advice);
    if (mesh.triangles.size() > kMaxTriangles)
      return refuse(en::say("the mesh has more than {} triangles", kMaxTriangles),
                    en::say("export a coarser mesh"));
  }
  if (mesh.triangles.empty())
    return refuse(en::say("the mesh has no triangles"), en::say("export it again as STL or OBJ"));
  return mesh;
}

Status check_closed(const TriangleMesh& mesh) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(std::minmax(t[k], t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  long open = 0;
  for (std::size_t i = 0, end; i < edges.size(); i = end) {
    for (end = i; end < edges.size() && edges[end] == edges[i];) ++end;
    if (end - i != 2) ++open;
  }
  if (open == 0) return {};
  return Error{en::say("the mesh has holes: {} edges do not border two triangles", open), "",
               en::say("close it in the program that made it")};
}

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
