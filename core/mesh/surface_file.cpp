#include "core/mesh/surface_file.h"

#include "core/base/atomic_file.h"
#include "core/image/colour_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::string ply(const Triangles& mesh) {
  std::string content = fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment millimetres; x along image u, y along image v, z away from the camera\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float depth_mm\nelement face {}\nproperty list uchar int "
      "vertex_indices\nend_header\n",
      mesh.points_mm.size(), mesh.corners.size());
  for (std::size_t i = 0; i < mesh.points_mm.size(); ++i) {
    append(content, mesh.points_mm[i]);
    append(content, mesh.depth_mm[i]);
  }
  for (const auto& corners : mesh.corners) {
    append(content, std::uint8_t{3});
    append(content, corners);
  }
  return content;
}

std::string vtp(const Triangles& mesh) {
  std::string data;
  const auto append_array = [&data](const std::string& bytes) {
    const std::size_t at = data.size();
    append(data, static_cast<std::uint64_t>(bytes.size()));
    data += bytes;
    return at;
  };
  std::vector<std::int32_t> ends;
  for (std::size_t i = 1; i <= mesh.corners.size(); ++i)
    ends.push_back(static_cast<std::int32_t>(3 * i));
  const std::size_t points = append_array(bytes_of(mesh.points_mm)),
                    depth = append_array(bytes_of(mesh.depth_mm));
  const std::size_t corners = append_array(bytes_of(mesh.corners)),
                    offsets = append_array(bytes_of(ends));
  const auto array = [](const char* type, const char* name, int components, std::size_t at) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, at);
  };
  return fmt::format(
             "<?xml version=\"1.0\"?>\n"
             "<!-- millimetres; x along image u, y along image v, z away from the camera -->\n"
             "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
             "header_type=\"UInt64\">\n<PolyData>\n"
             "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
             "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"
             "<PointData Scalars=\"depth_mm\">\n{}</PointData>\n<Points>\n{}</Points>\n"
             "<Polys>\n{}{}</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
             mesh.points_mm.size(), mesh.corners.size(), array("Float32", "depth_mm", 1, depth),
             array("Float32", "points_mm", 3, points), array("Int32", "connectivity", 1, corners),
             array("Int32", "offsets", 1, offsets)) +
         data + "\n</AppendedData>\n</VTKFile>\n";
}

std::string stl(const Triangles& mesh) {
  std::string content = "millimetres; x along image u, y along image v, z away from the camera";
  content.resize(80, ' ');
  append(content, static_cast<std::uint32_t>(mesh.corners.size()));
  for (const auto& corners : mesh.corners) {
    const auto corner = [&](std::size_t i) {
      return mesh.points_mm[static_cast<std::size_t>(corners[i])];
    };
    const cv::Vec3f a = corner(0), b = corner(1), c = corner(2);
    const cv::Vec3f across = (b - a).cross(c - a);
    const auto length = static_cast<float>(cv::norm(across));
    append(content, length > 0 ? cv::Vec3f(across / length) : cv::Vec3f(0, 0, -1));
    for (const cv::Vec3f& p : {a, b, c}) append(content, p);
    append(content, std::uint16_t{0});
  }
  return content;
}

/// glTF's vertex colours are linear light, not sRGB.
float light_of(std::uint8_t level) {
  const double part = level / 255.0;
  return static_cast<float>(part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4));
}

std::vector<cv::Vec3f> colours_of(const Triangles& mesh, double top_mm) {
  std::vector<cv::Vec3f> colours;
  for (const float depth : mesh.depth_mm) {
    const MapColour c = depth_colour(depth / top_mm);
    colours.emplace_back(light_of(c.red), light_of(c.green), light_of(c.blue));
  }
  return colours;
}

/// One of the four parts of the binary chunk.
struct GlbPart {
  std::string bytes;
  int component;  ///< glTF's number of the type
  const char* type;
  int target;  ///< use by a graphics card
  std::size_t count;
};

std::string glb(const Triangles& mesh) {
  using Json = nlohmann::ordered_json;
  constexpr int kFloat = 5126, kUnsigned = 5125, kVertices = 34962, kCorners = 34963;
  const std::size_t points = mesh.points_mm.size();
  double top_mm = 0.1;
  for (const float depth : mesh.depth_mm)
    if (std::isfinite(depth)) top_mm = std::max<double>(top_mm, depth);
  const std::vector<GlbPart> parts{
      {bytes_of(mesh.points_mm), kFloat, "VEC3", kVertices, points},
      {bytes_of(colours_of(mesh, top_mm)), kFloat, "VEC3", kVertices, points},
      {bytes_of(mesh.depth_mm), kFloat, "SCALAR", kVertices, points},
      {bytes_of(mesh.corners), kUnsigned, "SCALAR", kCorners, 3 * mesh.corners.size()}};
  std::string binary;
  Json views = Json::array(), accessors = Json::array();
  for (const GlbPart& part : parts) {
    views.push_back({{"buffer", 0},
                     {"byteOffset", binary.size()},
                     {"byteLength", part.bytes.size()},
                     {"target", part.target}});
    accessors.push_back({{"bufferView", accessors.size()},
                         {"componentType", part.component},
                         {"count", part.count},
                         {"type", part.type}});
    binary += part.bytes;
  }
  cv::Vec3f low = mesh.points_mm.front(), high = low;
  for (const cv::Vec3f& p : mesh.points_mm) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  accessors[0]["min"] = {low[0], low[1], low[2]};
  accessors[0]["max"] = {high[0], high[1], high[2]};
  // Half a turn about x: y up, z towards the viewer.
  const Json node = {{"mesh", 0}, {"rotation", {1, 0, 0, 0}}, {"scale", {1e-3, 1e-3, 1e-3}}};
  const Json primitive = {{"attributes", {{"POSITION", 0}, {"COLOR_0", 1}, {"_DEPTH_MM", 2}}},
                          {"indices", 3},
                          {"material", 0}};
  const Json surface = {{"primitives", Json::array({primitive})},
                        {"extras", {{"unit", "mm"}, {"colours_end_at_mm", top_mm}}}};
  const Json material = {
      {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 0.9}}},
      {"doubleSided", true}};
  const Json document = {{"asset", {{"version", "2.0"}, {"generator", "AllTact"}}},
                         {"scene", 0},
                         {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
                         {"nodes", Json::array({node})},
                         {"meshes", Json::array({surface})},
                         {"materials", Json::array({material})},
                         {"buffers", Json::array({{{"byteLength", binary.size()}}})},
                         {"bufferViews", views},
                         {"accessors", accessors}};
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string content = "glTF";
  append(content, std::uint32_t{2});
  append(content, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + binary.size()));
  append(content, static_cast<std::uint32_t>(text.size()));
  content += "JSON" + text;
  append(content, static_cast<std::uint32_t>(binary.size()));
  content += std::string("BIN\0", 4) + binary;
  return content;
}

}  // namespace

Status write_surface(const std::filesystem::path& file, const cv::Mat& points_mm,
                     const cv::Mat& depth_mm) {
  static const std::map<std::string, std::string (*)(const Triangles&)> kWriters{
      {".ply", &ply}, {".vtp", &vtp}, {".stl", &stl}, {".glb", &glb}};
  const auto writer = kWriters.find(file.extension().string());
  if (writer == kWriters.end())
    return Error{en::say("no surface can be written under such a name"), file.string(),
                 en::say("a name that ends in .ply, .vtp, .stl or .glb")};
  const Triangles mesh = triangles_of(points_mm, depth_mm);
  if (mesh.points_mm.empty())
    return Error{en::say("there is no point of the face to write"), file.string(), ""};
  return write_file_atomically(file, writer->second(mesh));
}

namespace {

bool is_finite(const cv::Vec3f& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

}  // namespace

Triangles triangles_of(const cv::Mat& points_mm, const cv::Mat& depth_mm) {
  CV_Assert(points_mm.type() == CV_32FC3 && depth_mm.type() == CV_32FC1 &&
            points_mm.size() == depth_mm.size());
  Triangles triangles;
  cv::Mat_<int> number(points_mm.size(), -1);
  for (int v = 0; v < points_mm.rows; ++v) {
    for (int u = 0; u < points_mm.cols; ++u) {
      const auto& p = points_mm.at<cv::Vec3f>(v, u);
      if (!is_finite(p)) continue;
      number(v, u) = static_cast<int>(triangles.points_mm.size());
      triangles.points_mm.push_back(p);
      triangles.depth_mm.push_back(depth_mm.at<float>(v, u));
    }
  }
  const auto add = [&](int a, int b, int c) {
    if (a >= 0 && b >= 0 && c >= 0) triangles.corners.push_back({a, b, c});
  };
  // In the image u grows to the right and v downwards, so anticlockwise is down first.
  for (int v = 0; v + 1 < number.rows; ++v) {
    for (int u = 0; u + 1 < number.cols; ++u) {
      add(number(v, u), number(v + 1, u), number(v, u + 1));
      add(number(v, u + 1), number(v + 1, u), number(v + 1, u + 1));
    }
  }
  return triangles;
}

}  // namespace alltact
