#include "core/io/ply.h"

#include "core/io/atomic_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace alltact {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY is written as it lies in memory");

template <class T>
void append(std::string& bytes, const T& value) {
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof(T));
  std::memcpy(bytes.data() + end, &value, sizeof(T));
}

bool is_finite(const cv::Vec3f& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

}  // namespace

Status write_ply(const std::filesystem::path& file,
                 const cv::Mat& points_mm,
                 const cv::Mat& depth_mm) {
  CV_Assert(points_mm.type() == CV_32FC3 && depth_mm.type() == CV_32FC1 &&
            points_mm.size() == depth_mm.size());
  cv::Mat_<int> number(points_mm.size(), -1);
  std::string vertices;
  int vertex_count = 0;
  for (int v = 0; v < points_mm.rows; ++v) {
    for (int u = 0; u < points_mm.cols; ++u) {
      const auto& p = points_mm.at<cv::Vec3f>(v, u);
      if (!is_finite(p)) continue;
      number(v, u) = vertex_count++;
      append(vertices, std::array<float, 4>{p[0], p[1], p[2], depth_mm.at<float>(v, u)});
    }
  }
  if (vertex_count == 0) return Error{"there is no point of the face to write", file.string(), ""};

  std::string faces;
  int face_count = 0;
  const auto add_face = [&](int a, int b, int c) {
    if (a < 0 || b < 0 || c < 0) return;
    append(faces, std::uint8_t{3});
    append(faces, std::array<std::int32_t, 3>{a, b, c});
    ++face_count;
  };
  // u grows to the right and v downwards as the camera sees them, so anticlockwise is down first.
  for (int v = 0; v + 1 < number.rows; ++v) {
    for (int u = 0; u + 1 < number.cols; ++u) {
      add_face(number(v, u), number(v + 1, u), number(v, u + 1));
      add_face(number(v, u + 1), number(v + 1, u), number(v + 1, u + 1));
    }
  }
  std::string content = fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment millimetres; x along image u, y along image v, z away from the camera\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float depth_mm\nelement face {}\nproperty list uchar int "
      "vertex_indices\nend_header\n",
      vertex_count,
      face_count);
  content += vertices;
  content += faces;
  return write_file_atomically(file, content);
}

}  // namespace alltact
