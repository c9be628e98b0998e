// PLY as assimp and others write it, in every type and byte order; and what is none is refused.
#include "core/thumbnail/read_ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <memory>
#include <random>
#include <string>

#include <assimp/Exporter.hpp>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::ElementsAre;
constexpr std::size_t kMost = 1000;

std::optional<Triangles> read(const std::string& bytes) {
  return read_ply(bytes, kMost);
}

/// Of one mesh, its points where `rng` has them.
std::unique_ptr<aiScene> random_scene(std::mt19937& rng, unsigned points, unsigned faces) {
  auto scene = std::make_unique<aiScene>();
  scene->mNumMaterials = scene->mNumMeshes = 1;
  scene->mMaterials = new aiMaterial* [1] { new aiMaterial() };
  auto* mesh = new aiMesh();
  scene->mMeshes = new aiMesh* [1] { mesh };
  scene->mRootNode = new aiNode();
  scene->mRootNode->mNumMeshes = 1;
  scene->mRootNode->mMeshes = new unsigned[1]{0};
  std::uniform_real_distribution<float> at(-50, 50);
  std::uniform_int_distribution<unsigned> corner(0, points - 1);
  mesh->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = points;
  mesh->mVertices = new aiVector3D[points];
  for (unsigned i = 0; i < points; ++i) mesh->mVertices[i] = {at(rng), at(rng), at(rng)};
  mesh->mNumFaces = faces;
  mesh->mFaces = new aiFace[faces];
  for (unsigned i = 0; i < faces; ++i) {
    mesh->mFaces[i].mNumIndices = 3;
    mesh->mFaces[i].mIndices = new unsigned[3]{corner(rng), corner(rng), corner(rng)};
  }
  return scene;
}

TEST(ReadPly, ReadsWhatAssimpWrites) {
  std::mt19937 rng(7);
  for (int i = 0; i < 20; ++i) {
    const auto scene = random_scene(rng, 3 + i, 1 + 5 * i);
    const aiMesh& mesh = *scene->mMeshes[0];
    for (const char* kind : {"ply", "plyb"}) {
      Assimp::Exporter exporter;
      const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), kind);
      ASSERT_NE(blob, nullptr) << exporter.GetErrorString();
      const auto triangles = read({static_cast<const char*>(blob->data), blob->size});
      ASSERT_TRUE(triangles) << kind << ' ' << i;
      ASSERT_EQ(triangles->points_mm.size(), mesh.mNumVertices);
      ASSERT_EQ(triangles->corners.size(), mesh.mNumFaces);
      EXPECT_TRUE(triangles->depth_mm.empty());
      for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
        const aiVector3D& p = mesh.mVertices[k];
        // As text it has six digits.
        EXPECT_LT(cv::norm(triangles->points_mm[k] - cv::Vec3f(p.x, p.y, p.z)),
                  kind == std::string("ply") ? 1e-4 : 1e-30);
      }
      for (unsigned k = 0; k < mesh.mNumFaces; ++k)
        for (unsigned c = 0; c < 3; ++c)
          EXPECT_EQ(triangles->corners[k].at(c), static_cast<int>(mesh.mFaces[k].mIndices[c]));
    }
  }
}

constexpr std::string_view kPoints =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
constexpr std::string_view kFaces =
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
constexpr std::string_view kBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

TEST(ReadPly, PassesOverWhatIsNotWanted) {
  const auto triangles = read(
      "ply\r\nformat ascii 1.0\r\ncomment of: somebody's \"program\"\r\nobj_info 3 rows\r\n"
      "element camera 2\r\nproperty list uchar float pose\r\nproperty int number\r\n"
      "element vertex 5\r\nproperty uchar red\r\nproperty double z\r\nproperty double y\r\n"
      "property double x\r\nproperty float depth_mm\r\n"
      "element face 5\r\nproperty list uchar float texcoord\r\n"
      "property list uint8 uint32 vertex_index\r\nproperty uchar flags\r\nend_header\r\n"
      "2 0.5 1.5 7\r\n0 8\r\n"
      "255 3 2 1 0.25\r\n0 0 0 0 0\r\n0 0 0 1 0\r\n0 0 1 1 0\r\n0 0 1 -1.5e0 0\r\n"
      "0 3 0 1 2 9\r\n2 0.5 0.5 4 1 2 3 4 9\r\n0 2 0 1 9\r\n0 1 0 9\r\n0 0 9\r\n");
  ASSERT_TRUE(triangles);
  EXPECT_EQ(triangles->points_mm.at(0), cv::Vec3f(1, 2, 3));
  EXPECT_EQ(triangles->points_mm.at(4), cv::Vec3f(-1.5F, 1, 0));
  EXPECT_THAT(triangles->depth_mm, ElementsAre(0.25F, 0, 0, 0, 0));
  // A polygon of four corners is two triangles; lines, points and faces of nothing are none.
  EXPECT_THAT(triangles->corners,
              ElementsAre(ElementsAre(0, 1, 2), ElementsAre(1, 2, 3), ElementsAre(1, 3, 4)));
}

TEST(ReadPly, RefusesAHeaderThatIsNone) {
  const std::string head = "ply\nformat ascii 1.0\n", points(kPoints), faces(kFaces), body(kBody);
  EXPECT_TRUE(read(head + points + faces + body));
  for (const std::string& header : {
           "ply\nformat ascii 1.0" + head + points + faces,
           "ply\n" + points + faces,
           "ply\nformat binary 1.0\n" + points + faces,
           "\n" + head + points + faces,
           head + head.substr(4) + points + faces,
           head + "property float w\n" + points + faces,
           head + "propevertexrty float z\n" + points + faces,
           head + points + "property soft w\n" + faces,
           head + points + "property list float int w\n" + faces,
           head + points + "property list uchar\n" + faces,
           head + points + "element edge\nproperty int w\n" + faces,
           head + points + "element edge -1\nproperty int w\n" + faces,
           head + points + "element edge 1.5\nproperty int w\n" + faces,
           head + points + "element edge 18446744073709551616\nproperty int w\n" + faces,
           head + points + "element edge 0\n" + faces,
           head + points + points + faces,
           head + points + faces.substr(0, faces.size() - 1),
           head + "element vertex 3\nproperty float x\nproperty float y\n" + faces,
           head + "element vertex 4000000000\nproperty float x\nproperty float y\n" +
               "property float z\n" + faces,
       })
    EXPECT_FALSE(read(header + body)) << header;
  EXPECT_FALSE(read(""));
  EXPECT_FALSE(read(head + points + faces));
  EXPECT_FALSE(read(head + points + faces + "0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n"));
}

/// `value` as a file of this byte order has it.
template <class T>
std::string bytes_of(T value, bool is_big_endian) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
  return {bytes.begin(), bytes.end()};
}

std::string binary_header(bool is_big_endian, const std::string& type, const std::string& list) {
  return fmt::format(
      "ply\nformat binary_{0}_endian 1.0\nelement vertex 3\nproperty {1} x\nproperty {1} y\n"
      "property {1} z\nelement face 1\nproperty list {2} vertex_indices\nend_header\n",
      is_big_endian ? "big" : "little",
      type,
      list);
}

/// One triangle, in whose list it says there are `corners`.
template <class T, class Length>
std::string triangle(bool is_big_endian,
                     const std::string& type,
                     const std::string& length,
                     Length corners) {
  std::string bytes = binary_header(is_big_endian, type, length + " " + type);
  for (const int value : {0, 0, 0, 100, 0, 0, 0, 1, 127})
    bytes += bytes_of(static_cast<T>(value), is_big_endian);
  bytes += bytes_of(corners, is_big_endian);
  for (const int corner : {0, 1, 2}) bytes += bytes_of(static_cast<T>(corner), is_big_endian);
  return bytes;
}

template <class T>
void expect_read_as(const std::string& type) {
  for (const bool is_big_endian : {false, true}) {
    const auto read_back = read(triangle<T>(is_big_endian, type, "ushort", std::uint16_t{3}));
    ASSERT_TRUE(read_back) << type << is_big_endian;
    EXPECT_THAT(read_back->points_mm,
                ElementsAre(cv::Vec3f(0, 0, 0), cv::Vec3f(100, 0, 0), cv::Vec3f(0, 1, 127)))
        << type;
    EXPECT_THAT(read_back->corners, ElementsAre(ElementsAre(0, 1, 2))) << type;
  }
}

TEST(ReadPly, KnowsEveryTypeInBothByteOrders) {
  for (const char* type : {"char", "int8"}) expect_read_as<std::int8_t>(type);
  for (const char* type : {"uchar", "uint8"}) expect_read_as<std::uint8_t>(type);
  for (const char* type : {"short", "int16"}) expect_read_as<std::int16_t>(type);
  for (const char* type : {"ushort", "uint16"}) expect_read_as<std::uint16_t>(type);
  for (const char* type : {"int", "int32"}) expect_read_as<std::int32_t>(type);
  for (const char* type : {"uint", "uint32"}) expect_read_as<std::uint32_t>(type);
  for (const char* type : {"float", "float32"}) expect_read_as<float>(type);
  for (const char* type : {"double", "float64"}) expect_read_as<double>(type);
}

TEST(ReadPly, RefusesDataThatEndBeforeWhatTheHeaderTells) {
  for (const bool is_big_endian : {false, true}) {
    const std::string whole = triangle<float>(is_big_endian, "float", "uchar", std::uint8_t{3});
    ASSERT_TRUE(read(whole));
    for (std::size_t size = 0; size < whole.size(); ++size)
      ASSERT_FALSE(read(whole.substr(0, size))) << size;
    const auto says = [&](auto corners, const std::string& type) {
      return read(triangle<std::int32_t>(is_big_endian, "int", type, corners)).has_value();
    };
    EXPECT_TRUE(says(std::int8_t{3}, "char"));
    EXPECT_FALSE(says(std::uint8_t{63}, "uchar"));
    EXPECT_FALSE(says(std::uint8_t{4}, "uchar"));
    EXPECT_FALSE(says(std::int8_t{-1}, "char"));
    EXPECT_FALSE(says(std::int32_t{-3}, "int"));
    EXPECT_FALSE(says(std::uint32_t{0xFFFFFFFFU}, "uint"));
  }
}

TEST(ReadPly, RefusesCornersThatAreNoNumbersOfPoints) {
  const std::string start = "ply\nformat ascii 1.0\n" + std::string(kPoints) +
                            "element face 1\nproperty list uchar float vertex_indices\n"
                            "end_header\n0 0 0\n1 0 0\n0 1 0\n";
  for (const char* face : {"3 0 1 -1", "3 0 1 3e9", "3 0 1 nan", "3 0 1 inf", "nan 0 1 2"})
    EXPECT_FALSE(read(start + face)) << face;
  EXPECT_TRUE(read(start + "3 0 1 2"));
}

TEST(ReadPly, GoesNoFurtherThanItIsAskedTo) {
  std::string text = "ply\nformat ascii 1.0\n" + std::string(kPoints) +
                     "element face 20\nproperty list uchar int vertex_indices\nend_header\n"
                     "0 0 0\n1 0 0\n0 1 0\n";
  for (int i = 0; i < 20; ++i) text += "3 0 1 2\n";
  EXPECT_EQ(read_ply(text, 20)->corners.size(), 20U);
  EXPECT_EQ(read_ply(text, 12)->corners.size(), 13U);
  EXPECT_FALSE(read_ply(text, 0));  // for three points
}

}  // namespace
}  // namespace alltact::test
