// PLY as assimp and others write it, in every type and byte order; and what is none is refused.
#include "core/thumbnail/thumbnail.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <random>
#include <string>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/mesh.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::ElementsAre;
constexpr std::size_t kMost = 1000;

std::optional<Triangles> read(const std::string& bytes) { return read_ply(bytes, kMost); }

/// A mesh as OBJ, its points where `rng` has them.
std::string random_obj(std::mt19937& rng, int points, int faces) {
  std::uniform_real_distribution<float> at(-50, 50);
  std::uniform_int_distribution<int> corner(1, points);
  std::string text;
  const auto out = std::back_inserter(text);
  for (int i = 0; i < points; ++i) fmt::format_to(out, "v {} {} {}\n", at(rng), at(rng), at(rng));
  for (int i = 0; i < faces; ++i)
    fmt::format_to(out, "f {} {} {}\n", corner(rng), corner(rng), corner(rng));
  return text;
}

void expect_same(const Triangles& triangles, const aiMesh& mesh, double most_off_mm) {
  ASSERT_EQ(triangles.points_mm.size(), mesh.mNumVertices);
  ASSERT_EQ(triangles.corners.size(), mesh.mNumFaces);
  EXPECT_TRUE(triangles.depth_mm.empty());
  for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
    const aiVector3D& p = mesh.mVertices[k];
    EXPECT_LE(cv::norm(triangles.points_mm[k] - cv::Vec3f(p.x, p.y, p.z)), most_off_mm);
  }
  for (unsigned k = 0; k < mesh.mNumFaces; ++k)
    for (unsigned c = 0; c < 3; ++c)
      EXPECT_EQ(triangles.corners[k].at(c), static_cast<int>(mesh.mFaces[k].mIndices[c]));
}

TEST(ReadPly, ReadsWhatAssimpWrites) {
  std::mt19937 rng(7);
  for (int i = 0; i < 20; ++i) {
    const std::string obj = random_obj(rng, 3 + i, 1 + 5 * i);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(obj.data(), obj.size(), 0, "obj");
    ASSERT_NE(scene, nullptr) << importer.GetErrorString();
    for (const char* kind : {"ply", "plyb"}) {
      Assimp::Exporter exporter;
      const aiExportDataBlob* blob = exporter.ExportToBlob(scene, kind);
      ASSERT_NE(blob, nullptr) << exporter.GetErrorString();
      const auto triangles = read({static_cast<const char*>(blob->data), blob->size});
      ASSERT_TRUE(triangles) << kind << ' ' << i;
      // As text it has six digits.
      expect_same(*triangles, *scene->mMeshes[0], kind == std::string("ply") ? 1e-4 : 0);
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
  const auto all = [](std::initializer_list<std::string_view> parts) {
    std::string text;
    for (const std::string_view part : parts) text += part;
    return text;
  };
  EXPECT_TRUE(read(all({head, points, faces, body})));
  for (const std::string& header : {
           all({"ply\nformat ascii 1.0", head, points, faces}),
           all({"ply\n", points, faces}),
           all({"ply\nformat binary 1.0\n", points, faces}),
           all({"\n", head, points, faces}),
           all({head, "format ascii 1.0\n", points, faces}),
           all({head, "property float w\n", points, faces}),
           all({head, "propevertexrty float z\n", points, faces}),
           all({head, points, "property soft w\n", faces}),
           all({head, points, "property list float int w\n", faces}),
           all({head, points, "property list uchar\n", faces}),
           all({head, points, "element edge\nproperty int w\n", faces}),
           all({head, points, "element edge -1\nproperty int w\n", faces}),
           all({head, points, "element edge 1.5\nproperty int w\n", faces}),
           all({head, points, "element edge 18446744073709551616\nproperty int w\n", faces}),
           all({head, points, "element edge 0\n", faces}),
           all({head, points, points, faces}),
           all({head, points, "element face 1\nproperty list uchar int vertex_indices"}),
           all({head, "element vertex 3\nproperty float x\nproperty float y\n", faces}),
           all({head, "element vertex 4000000000\nproperty float x\nproperty float y\n",
                "property float z\n", faces}),
       })
    EXPECT_FALSE(read(header + body)) << header;
  EXPECT_FALSE(read(""));
  EXPECT_FALSE(read(all({head, points, faces})));
  EXPECT_FALSE(read(all({head, points, faces, "0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n"})));
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
      is_big_endian ? "big" : "little", type, list);
}

/// One triangle, in whose list it says there are `corners`.
template <class T, class Length>
std::string triangle(bool is_big_endian, const std::string& type, const std::string& length,
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
