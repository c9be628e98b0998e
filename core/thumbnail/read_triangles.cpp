#include "core/thumbnail/read_triangles.h"

#include "core/io/atomic_file.h"
#include "core/io/scene_triangles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
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
constexpr std::size_t kMostTriangles = 4'000'000;
constexpr std::string_view kPlyEnd = "end_header\n";
using Json = nlohmann::json;

/// `count` values as they lie in a file, little end first; nullopt beyond its end.
template <class T>
std::optional<std::vector<T>> values_at(std::string_view bytes, std::size_t at, std::size_t count) {
  if (at > bytes.size() || count > (bytes.size() - at) / sizeof(T)) return std::nullopt;
  std::vector<T> values(count);
  if (count > 0)
    std::memcpy(static_cast<void*>(values.data()), bytes.data() + at, count * sizeof(T));
  return values;
}

/// The number behind `key`, up to the next letter that is no digit.
std::optional<std::size_t> number_behind(std::string_view text, std::string_view key) {
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  std::size_t number = 0;
  const char* begin = text.data() + at + key.size();
  const auto [end, status] = std::from_chars(begin, text.data() + text.size(), number);
  return status == std::errc{} && end != begin ? std::optional(number) : std::nullopt;
}

std::optional<Triangles> from_ply(std::string_view bytes) {
  const std::size_t end = bytes.find(kPlyEnd);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view header = bytes.substr(0, end);
  constexpr std::string_view kVertex =
      "property float x\nproperty float y\nproperty float z\nproperty float depth_mm\nelement face";
  constexpr std::string_view kFace = "property list uchar int vertex_indices\n";
  const auto points = number_behind(header, "element vertex "),
             faces = number_behind(header, "element face ");
  if (!points || !faces || !header.starts_with("ply\nformat binary_little_endian") ||
      header.find(kVertex) == std::string_view::npos || !header.ends_with(kFace))
    return std::nullopt;
  std::size_t at = end + kPlyEnd.size();
  const auto rows = values_at<std::array<float, 4>>(bytes, at, *points);
  if (!rows) return std::nullopt;
  at += rows->size() * sizeof(rows->front());
  Triangles triangles;
  for (const auto& [x, y, z, depth] : *rows) {
    triangles.points_mm.emplace_back(x, y, z);
    triangles.depth_mm.push_back(depth);
  }
  constexpr std::size_t kFaceBytes = 1 + 3 * sizeof(std::int32_t);
  if (*faces > (bytes.size() - at) / kFaceBytes) return std::nullopt;
  for (std::size_t i = 0; i < *faces; ++i, at += kFaceBytes) {
    if (bytes[at] != 3) return std::nullopt;
    triangles.corners.push_back(values_at<std::array<std::int32_t, 3>>(bytes, at + 1, 1)->front());
  }
  return triangles;
}

/// The array of this name among those appended raw, each behind its size.
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
      bytes.rfind("</AppendedData>") == std::string_view::npos)  // cut
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
    return std::nullopt;  // of another program: assimp's to read
  }
}

/// Words of a line without the carriage return at its end.
std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

struct PlyProperty {
  std::size_t bytes = 0;        // of one value
  std::size_t count_bytes = 0;  // of a list's length; 0: no list
  bool is_count_signed = false;
};

struct PlyElement {
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  std::string format;
  std::vector<PlyElement> elements;
  std::size_t data_at = 0;
};

/// Of a type's value; nullopt: no such type.
std::optional<std::size_t> ply_bytes(const std::string& type) {
  static const std::map<std::string, std::size_t, std::less<>> kBytes{{"char", 1},
                                                                      {"uchar", 1},
                                                                      {"short", 2},
                                                                      {"ushort", 2},
                                                                      {"int", 4},
                                                                      {"uint", 4},
                                                                      {"float", 4},
                                                                      {"double", 8},
                                                                      {"int8", 1},
                                                                      {"uint8", 1},
                                                                      {"int16", 2},
                                                                      {"uint16", 2},
                                                                      {"int32", 4},
                                                                      {"uint32", 4},
                                                                      {"float32", 4},
                                                                      {"float64", 8}};
  const auto known = kBytes.find(type);
  return known != kBytes.end() ? std::optional(known->second) : std::nullopt;
}

std::optional<PlyElement> ply_element(const std::vector<std::string>& words) {
  // assimp takes digits before a name for the count.
  if (words.size() != 3 || std::isalpha(static_cast<unsigned char>(words[1][0])) == 0)
    return std::nullopt;
  PlyElement element;
  const auto [rest, status] =
      std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
  return status == std::errc{} && *rest == '\0' ? std::optional(element) : std::nullopt;
}

std::optional<PlyProperty> ply_property(const std::vector<std::string>& words) {
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (!is_list && words.size() != 3) return std::nullopt;
  const auto bytes = ply_bytes(words[words.size() - 2]);
  const auto count_bytes = is_list ? ply_bytes(words[2]) : 0;
  if (!bytes || !count_bytes || (is_list && (*count_bytes > 4 || words[2].starts_with("float"))))
    return std::nullopt;
  return PlyProperty{*bytes, *count_bytes, is_list && words[2][0] != 'u'};
}

/// A header as its format has it (Turk, "The PLY polygon file format", 1994).
std::optional<PlyHeader> ply_header(std::string_view bytes) {
  const std::size_t end = bytes.find(kPlyEnd);
  if (end == std::string_view::npos || end == 0 || bytes[end - 1] != '\n') return std::nullopt;
  const std::string text(bytes.substr(0, end));
  if (text.find('\0') != std::string::npos) return std::nullopt;
  std::istringstream lines{text};
  std::string line;
  if (!std::getline(lines, line) || words_of(line) != std::vector<std::string>{"ply"})
    return std::nullopt;
  PlyHeader header;
  header.data_at = end + kPlyEnd.size();
  while (std::getline(lines, line)) {
    const auto words = words_of(line);
    if (words.empty()) return std::nullopt;
    if (words[0] == "comment" || words[0] == "obj_info") continue;
    const bool is_plain =
        std::all_of(words.back().begin(), words.back().end(), [](unsigned char c) {
          return std::isalnum(c) != 0 || c == '_' || c == '.';
        });
    if (!is_plain) return std::nullopt;
    auto& elements = header.elements;
    if (words[0] == "format" && words.size() == 3 && header.format.empty()) {
      header.format = words[1];
    } else if (words[0] == "element" && !header.format.empty()) {
      const auto element = ply_element(words);
      if (!element || (!elements.empty() && elements.back().properties.empty()))
        return std::nullopt;
      elements.push_back(*element);
    } else if (words[0] == "property" && !elements.empty()) {
      const auto property = ply_property(words);
      if (!property) return std::nullopt;
      elements.back().properties.push_back(*property);
    } else {
      return std::nullopt;
    }
  }
  if (header.elements.empty() || header.elements.back().properties.empty()) return std::nullopt;
  return header;
}

/// Goes over one element's bytes; false where they are not all there.
bool pass_element(const PlyElement& element,
                  std::string_view bytes,
                  bool is_big_endian,
                  std::size_t& at) {
  for (const PlyProperty& property : element.properties) {
    std::size_t values = 1;
    if (property.count_bytes > 0) {
      if (property.count_bytes > bytes.size() - at) return false;
      values = 0;
      for (std::size_t i = 0; i < property.count_bytes; ++i) {
        const std::size_t place = is_big_endian ? property.count_bytes - 1 - i : i;
        values |= std::size_t{static_cast<unsigned char>(bytes[at + i])} << (8 * place);
      }
      at += property.count_bytes;
      const std::size_t sign = std::size_t{1} << (8 * property.count_bytes - 1);
      if (property.is_count_signed && (values & sign) != 0) return false;
    }
    if (values > (bytes.size() - at) / property.bytes) return false;
    at += values * property.bytes;
  }
  return true;
}

/// A header in order, and behind it all that it tells of: of others assimp writes where it must
/// not, or never comes back.
bool is_ply(std::string_view bytes) {
  const auto header = ply_header(bytes);
  if (!header) return false;
  std::size_t at = header->data_at, elements = 0;
  const bool is_binary = header->format.starts_with("binary_");
  for (const PlyElement& element : header->elements) {
    if (element.count > bytes.size() - elements) return false;
    elements += element.count;
    for (std::size_t i = 0; is_binary && i < element.count; ++i)
      if (!pass_element(element, bytes, header->format == "binary_big_endian", at)) return false;
  }
  // In text, a digit and a break for each.
  return elements <= bytes.size() - header->data_at;
}

/// The first part lies within the file: assimp makes room for whatever size is told.
bool is_glb(std::string_view bytes) {
  constexpr std::size_t kSizesAt = 8;  // of the file, and of its first part
  const auto sizes = values_at<std::uint32_t>(bytes, kSizesAt, 2);
  return sizes && sizes->front() <= bytes.size() && sizes->back() <= bytes.size();
}

/// Validated, since its steps follow corners that are not there.
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
  auto triangles = kind == ".ply"   ? from_ply(*bytes)
                   : kind == ".vtp" ? from_vtp(*bytes)
                   : kind == ".glb" ? from_glb(*bytes)
                                    : std::nullopt;
  // assimp takes one of ours that ends among its faces for a whole one.
  const bool is_cut =
      (kind == ".glb" && !is_glb(*bytes)) ||
      (kind == ".ply" &&
       (!is_ply(*bytes) || bytes->find("property float depth_mm") != std::string::npos));
  if (!triangles && kind != ".vtp" && !is_cut) triangles = by_assimp(*bytes, kind.substr(1));
  if (!triangles) return refuse(en::say("the mesh cannot be read"));
  if (triangles->corners.empty()) return refuse(en::say("the mesh has no triangles"));
  if (triangles->corners.size() > kMostTriangles)
    return refuse(en::say("the mesh has more than {} triangles", kMostTriangles));
  if (!is_sound(*triangles)) return refuse(en::say("a point of the mesh is no number"));
  return std::move(*triangles);
}

}  // namespace alltact
