#include "core/base/atomic_file.h"
#include "core/base/letters.h"
#include "core/mesh/mesh_file.h"
#include "core/thumbnail/thumbnail.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
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
std::optional<std::vector<T>> glb_array(const Json& document, std::string_view binary,
                                        const Json& accessor) {
  const Json& described = document.at("accessors").at(accessor.get<std::size_t>());
  const Json& view = document.at("bufferViews").at(described.at("bufferView").get<std::size_t>());
  return values_at<T>(binary, view.at("byteOffset").get<std::size_t>(),
                      described.at("count").get<std::size_t>());
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
  importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_ValidateDataStructure,
                              kind.c_str());
  const aiScene* scene = scene_triangles(importer);
  if (scene == nullptr) return std::nullopt;
  Triangles triangles;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& part = *scene->mMeshes[i];
    const auto first = static_cast<std::int32_t>(triangles.points_mm.size());
    for (unsigned k = 0; k < part.mNumVertices; ++k)
      triangles.points_mm.emplace_back(part.mVertices[k].x, part.mVertices[k].y,
                                       part.mVertices[k].z);
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
  return std::all_of(triangles.corners.begin(), triangles.corners.end(),
                     [count](const std::array<std::int32_t, 3>& corners) {
                       return std::all_of(corners.begin(), corners.end(),
                                          [count](std::int32_t c) { return c >= 0 && c < count; });
                     }) &&
         std::all_of(triangles.points_mm.begin(), triangles.points_mm.end(),
                     [](const cv::Vec3f& p) {
                       return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
                     });
}

}  // namespace

Result<Triangles> read_triangles(const std::filesystem::path& file) {
  const auto refuse = [&](Message what) {
    return Error{std::move(what), file.string(), en::say("a file that a 3D program shows")};
  };
  const std::string kind = lowered_extension(file);
  if (kind != ".ply" && kind != ".vtp" && kind != ".glb" && kind != ".stl" && kind != ".obj")
    return Error{en::say("this mesh format is unknown"), file.string(),
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
  if (!is_sound(*triangles)) return refuse(en::say("a point of the mesh is not a number"));
  return std::move(*triangles);
}

namespace {

enum class Format { kText, kLittleEndian, kBigEndian };
enum class Number { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };
enum class Role { kIgnored, kX, kY, kZ, kDepth, kCorners };

struct Property {
  Role role = Role::kIgnored;
  Number number = Number::kFloat;
  std::optional<Number> length = std::nullopt;  // of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
  [[nodiscard]] bool has(Role role) const {
    return std::any_of(properties.begin(), properties.end(),
                       [role](const auto& p) { return p.role == role; });
  }
};

struct Header {
  std::optional<Format> format;
  std::vector<Element> elements;
};

constexpr std::size_t kMaxCorners = 1 << 20;  // of one polygon
constexpr std::string_view kBlank = " \t\r\n\v\f";

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(kBlank); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlank, end);
  }
  return words;
}

std::optional<Number> number_named(std::string_view type) {
  struct Named {
    std::string_view name, sized_name;
    Number number;
  };
  static constexpr Named kNamed[] = {
      {"char", "int8", Number::kInt8},      {"uchar", "uint8", Number::kUint8},
      {"short", "int16", Number::kInt16},   {"ushort", "uint16", Number::kUint16},
      {"int", "int32", Number::kInt32},     {"uint", "uint32", Number::kUint32},
      {"float", "float32", Number::kFloat}, {"double", "float64", Number::kDouble}};
  for (const Named& named : kNamed)
    if (type == named.name || type == named.sized_name) return named.number;
  return std::nullopt;
}

Role role_of(std::string_view element, std::string_view property, bool is_list) {
  if (is_list) {
    const bool is_corners = property == "vertex_indices" || property == "vertex_index";
    return element == "face" && is_corners ? Role::kCorners : Role::kIgnored;
  }
  if (element != "vertex") return Role::kIgnored;
  if (property == "x") return Role::kX;
  if (property == "y") return Role::kY;
  if (property == "z") return Role::kZ;
  return property == "depth_mm" ? Role::kDepth : Role::kIgnored;
}

bool add_format(const std::vector<std::string_view>& words, Header& header) {
  if (words.size() != 3 || header.format) return false;
  if (words[1] == "ascii") header.format = Format::kText;
  if (words[1] == "binary_little_endian") header.format = Format::kLittleEndian;
  if (words[1] == "binary_big_endian") header.format = Format::kBigEndian;
  return header.format.has_value();
}

bool add_element(const std::vector<std::string_view>& words, Header& header) {
  if (words.size() != 3) return false;
  auto& elements = header.elements;
  Element element{std::string(words[1]), 0, {}};
  const char* end = words[2].data() + words[2].size();
  const auto [rest, status] = std::from_chars(words[2].data(), end, element.count);
  const bool is_known = std::any_of(elements.begin(), elements.end(), [&](const Element& other) {
    return other.name == element.name;
  });
  if (status != std::errc{} || rest != end || is_known) return false;
  elements.push_back(std::move(element));
  return true;
}

bool add_property(const std::vector<std::string_view>& words, Header& header) {
  if (header.elements.empty()) return false;
  const bool is_list = words.size() == 5 && words[1] == "list";
  if (!is_list && words.size() != 3) return false;
  Element& element = header.elements.back();
  Property property{role_of(element.name, words.back(), is_list)};
  const auto number = number_named(words[words.size() - 2]);
  if (is_list) property.length = number_named(words[2]);
  const bool has_length = property.length && *property.length < Number::kFloat;
  if (!number || (is_list && !has_length)) return false;
  property.number = *number;
  element.properties.push_back(property);
  return true;
}

/// Parses the header and removes it from the front of `rest`.
std::optional<Header> take_header(std::string_view& rest) {
  Header header;
  for (bool is_first = true;; is_first = false) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const auto words = words_of(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    if (words.empty() || (is_first && (words.size() != 1 || words[0] != "ply")))
      return std::nullopt;
    if (is_first || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header") break;
    const bool is_good = words[0] == "format"     ? add_format(words, header)
                         : words[0] == "element"  ? add_element(words, header)
                         : words[0] == "property" ? add_property(words, header)
                                                  : false;
    if (!is_good) return std::nullopt;
  }
  return header.format ? std::optional(std::move(header)) : std::nullopt;
}

/// The numbers behind a header, in order.
class Numbers {
 public:
  Numbers(std::string_view rest, Format format) : rest_(rest), format_(format) {}
  [[nodiscard]] std::size_t bytes_left() const { return rest_.size(); }

  /// nullopt: the data end, or hold something else.
  std::optional<double> next(Number number) {
    if (format_ == Format::kText) return next_word();
    switch (number) {
      case Number::kInt8:
        return next_as<std::int8_t>();
      case Number::kUint8:
        return next_as<std::uint8_t>();
      case Number::kInt16:
        return next_as<std::int16_t>();
      case Number::kUint16:
        return next_as<std::uint16_t>();
      case Number::kInt32:
        return next_as<std::int32_t>();
      case Number::kUint32:
        return next_as<std::uint32_t>();
      case Number::kFloat:
        return next_as<float>();
      case Number::kDouble:
        return next_as<double>();
    }
    return std::nullopt;
  }

 private:
  template <class T>
  std::optional<double> next_as() {
    std::array<char, sizeof(T)> bytes{};
    if (rest_.size() < bytes.size()) return std::nullopt;
    std::memcpy(bytes.data(), rest_.data(), bytes.size());
    rest_.remove_prefix(bytes.size());
    if (format_ == Format::kBigEndian) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<T>(bytes));
  }

  std::optional<double> next_word() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlank), rest_.size()));
    double number = 0;
    const char* end = rest_.data() + rest_.size();
    const auto [after, status] = std::from_chars(rest_.data(), end, number);
    if (status != std::errc{}) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(after - rest_.data()));
    return number;
  }

  std::string_view rest_;
  Format format_;
};

/// The used content of one row of an element.
struct Row {
  std::array<double, 5> of_role{};
  std::vector<std::int32_t> corners;
};

bool read_list(const Property& list, Numbers& numbers, Row& row) {
  const auto length = numbers.next(*list.length);
  if (!length || !(*length >= 0) || *length > static_cast<double>(numbers.bytes_left()))
    return false;
  for (auto left = static_cast<std::size_t>(*length); left > 0; --left) {
    const auto number = numbers.next(list.number);
    if (!number) return false;
    if (list.role != Role::kCorners) continue;
    if (!(*number >= 0) || *number > std::numeric_limits<std::int32_t>::max() ||
        row.corners.size() == kMaxCorners)
      return false;
    row.corners.push_back(static_cast<std::int32_t>(*number));
  }
  return true;
}

bool read_row(const Element& element, Numbers& numbers, Row& row) {
  row.corners.clear();
  for (const Property& property : element.properties) {
    if (property.length) {
      if (!read_list(property, numbers, row)) return false;
    } else {
      const auto number = numbers.next(property.number);
      if (!number) return false;
      row.of_role.at(static_cast<std::size_t>(property.role)) = *number;
    }
  }
  return true;
}

void add_point(const Element& element, const Row& row, Triangles& triangles) {
  const auto number = [&](Role role) {
    return static_cast<float>(row.of_role.at(static_cast<std::size_t>(role)));
  };
  triangles.points_mm.emplace_back(number(Role::kX), number(Role::kY), number(Role::kZ));
  if (element.has(Role::kDepth)) triangles.depth_mm.push_back(number(Role::kDepth));
}

void add_face(const Row& row, Triangles& triangles) {
  for (std::size_t k = 2; k < row.corners.size(); ++k)  // none for points and lines
    triangles.corners.push_back({row.corners[0], row.corners[k - 1], row.corners[k]});
}

}  // namespace

std::optional<Triangles> read_ply(std::string_view bytes, std::size_t max_triangles) {
  const auto header = take_header(bytes);
  if (!header) return std::nullopt;
  Numbers numbers(bytes, *header->format);
  Triangles triangles;
  Row row;
  for (const Element& element : header->elements) {
    const bool is_point = element.name == "vertex";
    if (element.properties.empty() || element.count > numbers.bytes_left()) return std::nullopt;
    if (is_point && (!element.has(Role::kX) || !element.has(Role::kY) || !element.has(Role::kZ) ||
                     element.count > 3 * max_triangles))
      return std::nullopt;
    for (std::size_t i = 0; i < element.count; ++i) {
      if (!read_row(element, numbers, row)) return std::nullopt;
      if (is_point) add_point(element, row, triangles);
      add_face(row, triangles);
      if (triangles.corners.size() > max_triangles) return triangles;
    }
  }
  return triangles;
}

}  // namespace alltact
