#include "core/mesh/surface_file.h"

#include "tests/support/temporary_folder.h"

#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

struct Mesh {
  std::vector<std::array<float, 4>> vertices;
  std::vector<std::array<std::int32_t, 3>> faces;
  std::size_t left_over = 0;
};

/// Reads what the header says, with nothing of the writer.
Mesh read_mesh(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(stream, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string element, kind;
    std::size_t count = 0;
    if (words >> element >> kind >> count && element == "element")
      (kind == "vertex" ? vertices : faces) = count;
  }
  Mesh mesh;
  mesh.vertices.resize(vertices);
  stream.read(reinterpret_cast<char*>(mesh.vertices.data()),
              static_cast<std::streamsize>(16 * vertices));
  for (std::size_t i = 0; i < faces; ++i) {
    char corners = 0;
    mesh.faces.emplace_back();
    stream.read(&corners, 1).read(reinterpret_cast<char*>(mesh.faces.back().data()), 12);
    EXPECT_EQ(corners, 3);
  }
  EXPECT_TRUE(stream.good());
  while (stream.get() != std::ifstream::traits_type::eof()) ++mesh.left_over;
  return mesh;
}

class SurfaceFile : public testing::Test {
 protected:
  SurfaceFile() : points_(4, 5, CV_32FC3), depth_(4, 5, CV_32FC1) {
    for (int v = 0; v < 4; ++v) {
      for (int u = 0; u < 5; ++u) {
        points_.at<cv::Vec3f>(v, u) = {0.5F * static_cast<float>(u), 0.25F * static_cast<float>(v),
                                       40};
        depth_.at<float>(v, u) = static_cast<float>(10 * v + u);
      }
    }
  }
  cv::Mat points_, depth_;
  test::TemporaryFolder folder_;
  const fs::path file_ = folder_ / "surface.ply";
};

TEST_F(SurfaceFile, AGridIsWholeAndFacesTheCamera) {
  ASSERT_TRUE(write_surface(file_, points_, depth_).ok());
  const Mesh mesh = read_mesh(file_);
  EXPECT_EQ(mesh.vertices.size(), 20U);
  EXPECT_EQ(mesh.faces.size(), 2U * 3U * 4U);
  EXPECT_EQ(mesh.left_over, 0U);
  EXPECT_EQ(mesh.vertices[7][3], 12.0F);
  double area = 0;
  for (const auto& face : mesh.faces) {
    const auto corner = [&](int i) {
      const auto& p = mesh.vertices.at(static_cast<std::size_t>(face[static_cast<std::size_t>(i)]));
      return Eigen::Vector3d(p[0], p[1], p[2]);
    };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    EXPECT_LT(normal.z(), 0) << "towards the camera, which looks along z";
    area += normal.norm() / 2;
  }
  EXPECT_NEAR(area, 4 * 0.5 * 3 * 0.25, 1e-6);
}

TEST_F(SurfaceFile, HolesStayHoles) {
  points_.at<cv::Vec3f>(1, 2)[2] = std::numeric_limits<float>::quiet_NaN();
  ASSERT_TRUE(write_surface(file_, points_, depth_).ok());
  const Mesh mesh = read_mesh(file_);
  EXPECT_EQ(mesh.vertices.size(), 19U);
  EXPECT_EQ(mesh.faces.size(), 24U - 6U) << "an inner point belongs to six triangles";
  std::set<float> depths;
  for (const auto& vertex : mesh.vertices) depths.insert(vertex[3]);
  EXPECT_FALSE(depths.contains(12.0F));
}

TEST_F(SurfaceFile, NothingIsNotWritten) {
  points_.setTo(cv::Scalar::all(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(write_surface(file_, points_, depth_).ok());
  EXPECT_FALSE(fs::exists(file_));
}

}  // namespace
}  // namespace alltact
