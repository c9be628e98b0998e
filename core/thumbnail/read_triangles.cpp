#include "core/thumbnail/read_triangles.h"

#include "core/io/atomic_file.h"
#include "core/io/scene_triangles.h"
#include "core/thumbnail/read_ply.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

constexpr std::size_t kLargestFile = std::size_t{512} << 20;
constexpr std::size_t kMaxTriangles = 4'000'000;
using Json = nlohmann::json;

/// `count` values of a file, little-endian; nullopt beyond its end.
template <class T>
std::optional<std::vector<T>> values_at(std::string_view bytes, std::size_t at, std::size_t count) {
  if (at > bytes.size() || count > (bytes.size() - at) / sizeof(T)) return std::nullopt;
  std::vector<T> values(count);
  if (count > 0)
    std::memcpy(static_cast<void*>(values.data()), bytes.data() + at, count * sizeof(T));
  return values;
}

/// The number behind `key`, up to the next character that is no digit.
std::optional<std::size_t> number_behind(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  std::size_t number = 0;
  const char* begin = text.data() + at + key.size();
  const auto [end, status] = std::from_chars(begin, text.data() + text.size(), number);
  return status == std::errc{} && end != begin ? std::optional(number) : std::nullopt;
}

/// The array of this name in the raw appended data, each behind its size.
template <class T>
std::optional<std::vector<T>> vtp_array(std::string_view bytes, std::string_view name) {
  constexpr std::string_view kData = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t data = bytes.find(kData);
  if (data == std::string_view::npos) return std::nullopt;
  const std::string_view header = bytes.substr(0, data);
  const std::size_t array = header.find("Name=\"" + std::string(name) + "\"");
  if (array == std::string_view::npos) return std::nullopt;
  const auto offset = number_behind(header.substr(array), "offset=\"");
  if (!offset || *offset > bytes.size()) return std::nullopt;
  const std::size_t at = data + kData.size() + *offset;
  const auto size = values_at<std::uint64_t>(bytes, at, 1);
  if (!size) return std::nullopt;
  return values_at<T>(bytes, at + sizeof(std::uint64_t), size->front() / sizeof(T));
}

std::optional<Triangles> from_vtp(std::string_view bytes) {
  if (bytes.find("type=\"PolyData\"") == std::string_view::npos ||
      bytes.find("header_type=\"UInt64\"") == std::string_view::npos ||
      bytes.rfind("</AppendedData>") == std::string_view::npos)  // truncated
    return std::nullopt;
  auto points = vtp_array<cv::Vec3f>(bytes, "points_mm");
  auto depth = vtp_array<float>(bytes, "depth_mm");
  auto corners = vtp_array<std::array<std::int32_t, 3>>(bytes, "connectivity");
  if (!points || !depth || !corners || depth->size() != points->size()) return std::nullopt;
  return Triangles{std::move(*points), std::move(*depth), std::move(*corners)};
}

/// An accessor of the first primitive, all of whose bytes lie in the binary chunk.
template <class T>
std::optional<std::vector<T>> glb_array(const Json& document,
                                        std::string_view binary,
                                        const Json& accessor) {
  const Json& described = document.at("accessors").at(accessor.get<std::size_t>());
  const Json& view = document.at("bufferViews").at(described.at("bufferView").get<std::size_t>());
  return values_at<T>(
      binary, view.at("byteOffset").get<std::size_t>(), described.at("count").get<std::size_t>());
}

std::optional<Triangles> from_glb(std::string_view bytes) {
  constexpr std::size_t kHead = 12, kChunkHead = 8;
  const auto json_size = values_at<std::uint32_t>(bytes, kHead, 1);
  if (!json_size || !bytes.starts_with("glTF")) return std::nullopt;
  const std::size_t binary_at = kHead + kChunkHead + json_size->front() + kChunkHead;
  if (binary_at > bytes.size()) return std::nullopt;
  const auto document =
      Json::parse(bytes.substr(kHead + kChunkHead, json_size->front()), nullptr, false);
  if (document.is_discarded()) return std::nullopt;
  const std::string_view binary = bytes.substr(binary_at);
  try {
    const Json& primitive = document.at("meshes").at(0).at("primitives").at(0);
    const Json& attributes = primitive.at("attributes");
    if (!attributes.contains("_DEPTH_MM")) return std::nullopt;
    auto points = glb_array<cv::Vec3f>(document, binary, attributes.at("POSITION"));
    auto depth = glb_array<float>(document, binary, attributes.at("_DEPTH_MM"));
    const auto flat = glb_array<std::int32_t>(document, binary, primitive.at("indices"));
    if (!points || !depth || !flat || depth->size() != points->size()) return std::nullopt;
    Triangles triangles{std::move(*points), std::move(*depth), {}};
    for (std::size_t i = 0; i + 2 < flat->size(); i += 3)
      triangles.corners.push_back({(*flat)[i], (*flat)[i + 1], (*flat)[i + 2]});
    return triangles;
  } catch (const Json::exception&) {
    return std::nullopt;  // of another program: assimp reads it
  }
}

/// Checks that the first chunk lies within the file: assimp allocates whatever size the file
/// states.
bool is_glb(std::string_view bytes) {
  constexpr std::size_t kSizesAt = 8;  // of the file, and of its first chunk
  const auto sizes = values_at<std::uint32_t>(bytes, kSizesAt, 2);
  return sizes && sizes->front() <= bytes.size() && sizes->back() <= bytes.size();
}

/// Validated, since its steps follow corners that are out of range.
std::optional<Triangles> by_assimp(const std::string& bytes, const std::string& kind) {
  Assimp::Importer importer;
  importer.ReadFileFromMemory(
      bytes.data(), bytes.size(), aiProcess_ValidateDataStructure, kind.c_str());
  const aiScene* scene = scene_triangles(importer);
  if (scene == nullptr) return std::nullopt;
  Triangles triangles;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& part = *scene->mMeshes[i];
    const auto first = static_cast<std::int32_t>(triangles.points_mm.size());
    for (unsigned k = 0; k < part.mNumVertices; ++k)
      triangles.points_mm.emplace_back(
          part.mVertices[k].x, part.mVertices[k].y, part.mVertices[k].z);
    for (unsigned k = 0; k < part.mNumFaces; ++k) {
      const aiFace& face = part.mFaces[k];
      if (face.mNumIndices != 3) continue;  // points and lines
      const auto corner = [&](int c) {
        return first + static_cast<std::int32_t>(face.mIndices[c]);
      };
      triangles.corners.push_back({corner(0), corner(1), corner(2)});
    }
  }
  return triangles;
}

bool is_sound(const Triangles& triangles) {
  const auto count = static_cast<std::int32_t>(triangles.points_mm.size());
  return std::all_of(triangles.corners.begin(),
                     triangles.corners.end(),
                     [count](const std::array<std::int32_t, 3>& corners) {
                       return std::all_of(corners.begin(), corners.end(), [count](std::int32_t c) {
                         return c >= 0 && c < count;
                       });
                     }) &&
         std::all_of(
             triangles.points_mm.begin(), triangles.points_mm.end(), [](const cv::Vec3f& p) {
               return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
             });
}

}  // namespace

Result<Triangles> read_triangles(const std::filesystem::path& file) {
  const auto refuse = [&](Message what) {
    return Error{std::move(what), file.string(), en::say("a file that a 3D program shows")};
  };
  std::string kind = file.extension().string();
  std::transform(
      kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return std::tolower(c); });
  if (kind != ".ply" && kind != ".vtp" && kind != ".glb" && kind != ".stl" && kind != ".obj")
    return Error{en::say("this is not known as a mesh"),
                 file.string(),
                 en::say("a file that ends in .ply, .vtp, .glb, .stl or .obj")};
  const auto bytes = read_file(file, kLargestFile);
  if (!bytes) return bytes.error();
  auto triangles = kind == ".ply"   ? read_ply(*bytes, kMaxTriangles)
                   : kind == ".vtp" ? from_vtp(*bytes)
                   : kind == ".glb" ? from_glb(*bytes)
                                    : std::nullopt;
  const bool is_for_assimp = kind == ".stl" || kind == ".obj" || (kind == ".glb" && is_glb(*bytes));
  if (!triangles && is_for_assimp) triangles = by_assimp(*bytes, kind.substr(1));
  if (!triangles) return refuse(en::say("the mesh cannot be read"));
  if (triangles->corners.empty()) return refuse(en::say("the mesh has no triangles"));
  if (triangles->corners.size() > kMaxTriangles)
    return refuse(en::say("the mesh has more than {} triangles", kMaxTriangles));
  if (!is_sound(*triangles)) return refuse(en::say("a point of the mesh is no number"));
  return std::move(*triangles);
}

}  // namespace alltact
