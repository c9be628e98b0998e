// Meshes that were written are read as they were, and those that were cut are refused.

#include "core/mesh/surface_file.h"
#include "core/thumbnail/thumbnail.h"
#include "tests/support/program.h"

#include <algorithm>
#include <array>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact::test {
namespace {

using testing::HasSubstr;

class ReadTriangles : public testing::Test {
 protected:
  ReadTriangles() : points_(6, 9, CV_32FC3), depth_(6, 9, CV_32FC1) {
    for (int v = 0; v < points_.rows; ++v)
      for (int u = 0; u < points_.cols; ++u) {
        points_.at<cv::Vec3f>(v, u) = cv::Vec3f(0.5F * float(u), 0.25F * float(v), 40);
        depth_.at<float>(v, u) = 0.01F * static_cast<float>(10 * v + u);
      }
    points_.at<cv::Vec3f>(2, 3)[2] = std::numeric_limits<float>::quiet_NaN();
  }
  std::filesystem::path write(const std::string& name) {
    EXPECT_TRUE(write_surface(folder_ / name, points_, depth_).ok());
    return folder_ / name;
  }
  TemporaryFolder folder_;
  cv::Mat points_, depth_;
};

TEST_F(ReadTriangles, GivesBackWhatWasWrittenWithItsDepth) {
  const Triangles wanted = triangles_of(points_, depth_);
  for (const char* name : {"a.ply", "a.vtp", "a.glb"}) {
    const auto read = read_triangles(write(name));
    ASSERT_TRUE(read.ok()) << name << read.error().sentence();
    EXPECT_EQ(read.value().points_mm, wanted.points_mm) << name;
    EXPECT_EQ(read.value().depth_mm, wanted.depth_mm) << name;
    EXPECT_EQ(read.value().corners, wanted.corners) << name;
  }
}

TEST_F(ReadTriangles, RefusesAGlbWhosePartsAreLargerThanIt) {
  std::string bytes = text_of(write("a.glb"));
  bytes.replace(12, 4, "\xfe\xff\xff\xef");
  write_text(folder_ / "large.glb", bytes);
  EXPECT_FALSE(read_triangles(folder_ / "large.glb").ok());
}

TEST_F(ReadTriangles, ReadsThoseOfOtherProgramsWithoutDepth) {
  const auto stl = read_triangles(write("a.stl"));
  ASSERT_TRUE(stl.ok()) << stl.error().sentence();
  EXPECT_EQ(stl.value().corners.size(), triangles_of(points_, depth_).corners.size());
  EXPECT_TRUE(stl.value().depth_mm.empty());
  write_text(folder_ / "b.ply",
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
             "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
             "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto ply = read_triangles(folder_ / "b.ply");
  ASSERT_TRUE(ply.ok()) << ply.error().sentence();
  EXPECT_EQ(ply.value().corners.size(), 1U);
  write_text(folder_ / "c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_TRUE(read_triangles(folder_ / "c.obj").ok());
}

TEST_F(ReadTriangles, RefusesWhatIsCutAnywhere) {
  for (const char* name : {"a.ply", "a.vtp", "a.glb"}) {
    const std::string whole = text_of(write(name));
    // What follows the last triangle in a .vtp only closes its XML.
    const std::size_t data_end = whole.find("\n</AppendedData>");
    for (std::size_t size = 0; size < std::min(whole.size(), data_end); size += 7) {
      write_text(folder_ / name, whole.substr(0, size));
      const auto read = read_triangles(folder_ / name);
      ASSERT_FALSE(read.ok()) << name << " cut to " << size;
      EXPECT_THAT(read.error().sentence(), HasSubstr(name));
    }
  }
}

TEST_F(ReadTriangles, RefusesCornersThatAreNotThereAndOtherKinds) {
  std::string ply = text_of(write("a.ply"));
  ply[ply.size() - 1] = '\x7f';
  write_text(folder_ / "a.ply", ply);
  EXPECT_FALSE(read_triangles(folder_ / "a.ply").ok());
  write_text(folder_ / "a.txt", "");
  EXPECT_THAT(read_triangles(folder_ / "a.txt").error().sentence(), HasSubstr(".vtp"));
  EXPECT_FALSE(read_triangles(folder_ / "none.stl").ok());
  EXPECT_FALSE(thumbnail_of(folder_ / "none.depth.tiff", 64).ok());
}

}  // namespace
}  // namespace alltact::test
