// Small pictures against what geometry says of them.
#include "core/thumbnail/thumbnail.h"

#include "core/image/colour_map.h"
#include "core/image/image_file.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact::test {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

double distance(const cv::Vec4b& seen, const MapColour& wanted) {
  return std::hypot(seen[2] - wanted.red, seen[1] - wanted.green, seen[0] - wanted.blue);
}

double covered(const cv::Mat& image) {
  cv::Mat opacity;
  cv::extractChannel(image, opacity, 3);
  return cv::mean(opacity)[0] / 255;
}

TEST(DepthThumbnail, ColoursEndAtTheDeepestAndNothingIsClear) {
  cv::Mat depth(100, 200, CV_32FC1, cv::Scalar(0));
  depth(cv::Rect(0, 0, 100, 50)).setTo(0.8F);
  depth(cv::Rect(100, 50, 100, 50)).setTo(kNone);
  const cv::Mat small = depth_thumbnail(depth, 64);
  EXPECT_EQ(small.size(), cv::Size(64, 32));
  EXPECT_LT(distance(small.at<cv::Vec4b>(8, 16), depth_colour(1)), 1.8);
  EXPECT_LT(distance(small.at<cv::Vec4b>(8, 48), depth_colour(0)), 1.8);
  EXPECT_EQ(small.at<cv::Vec4b>(24, 48)[3], 0);
  EXPECT_NEAR(covered(small), 0.75, 0.01);
}

TEST(DepthThumbnail, WhatIsClearHasNoPartInTheColoursBesideIt) {
  cv::Mat depth(64, 64, CV_32FC1, cv::Scalar(0.5));
  for (int u = 0; u < 64; u += 2) depth.col(u).setTo(kNone);
  const cv::Mat small = depth_thumbnail(depth, 16);
  for (int v = 0; v < 16; ++v)
    for (int u = 0; u < 16; ++u)
      EXPECT_LT(distance(small.at<cv::Vec4b>(v, u), depth_colour(1)), 1.8) << u << ' ' << v;
  EXPECT_NEAR(covered(small), 0.5, 0.01);
}

TEST(DepthThumbnail, NoiseOfAnUntouchedFaceIsNotBlownUp) {
  const cv::Mat depth(10, 10, CV_32FC1, cv::Scalar(0.01));
  EXPECT_LT(distance(depth_thumbnail(depth, 16).at<cv::Vec4b>(8, 8), depth_colour(0.1)), 1.8);
}

/// A ball of triangles, `steps` from pole to pole.
Triangles ball(int steps) {
  Triangles mesh;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const double a = std::numbers::pi * i / steps, b = std::numbers::pi * j / steps;
      mesh.points_mm.emplace_back(static_cast<float>(5 * std::sin(a) * std::cos(b)),
                                  static_cast<float>(5 * std::sin(a) * std::sin(b)),
                                  static_cast<float>(5 * std::cos(a)));
    }
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < 2 * steps; ++j) {
      const int right = (j + 1) % (2 * steps), here = i * 2 * steps, below = here + 2 * steps;
      mesh.corners.push_back({here + j, below + j, here + right});
      mesh.corners.push_back({here + right, below + j, below + right});
    }
  return mesh;
}

TEST(MeshThumbnail, ABallIsADisc) {
  const cv::Mat image = mesh_thumbnail(ball(48), 128);
  EXPECT_EQ(image.size(), cv::Size(128, 128));
  constexpr double kFilled = 0.94;
  EXPECT_NEAR(covered(image), std::numbers::pi / 4 * kFilled * kFilled, 0.005);
  // Its middle is in the middle, and it is lit from one side.
  cv::Mat opacity;
  cv::extractChannel(image, opacity, 3);
  const cv::Moments moments = cv::moments(opacity);
  EXPECT_NEAR(moments.m10 / moments.m00, 63.5, 0.5);
  EXPECT_NEAR(moments.m01 / moments.m00, 63.5, 0.5);
  EXPECT_GT(image.at<cv::Vec4b>(36, 46)[1], image.at<cv::Vec4b>(96, 90)[1] + 20);
}

/// Two squares, one behind the other as the plates' depth says in colours.
TEST(MeshThumbnail, WhatIsNearerHidesWhatIsFarther) {
  Triangles plates;
  for (const auto& [z, half, depth] : {std::tuple{0.F, 10.F, 0.F}, {-1.F, 10.F, 1.F}}) {
    const auto first = static_cast<std::int32_t>(plates.points_mm.size());
    for (const auto& [x, y] : {std::pair{-2.F, -1.F}, {2.F, -1.F}, {2.F, 1.F}, {-2.F, 1.F}}) {
      plates.points_mm.emplace_back(half * x, half * y, z);
      plates.depth_mm.push_back(depth);
    }
    // Anticlockwise seen from where z is negative.
    plates.corners.push_back({first, first + 3, first + 1});
    plates.corners.push_back({first + 1, first + 3, first + 2});
  }
  const cv::Mat image = mesh_thumbnail(plates, 64);
  const cv::Vec4b& middle = image.at<cv::Vec4b>(32, 32);
  const MapColour yellow = depth_colour(1);
  // In the yellow of the nearer plate, darker by its slope towards the light.
  EXPECT_NEAR(static_cast<double>(middle[1]) / middle[2],
              static_cast<double>(yellow.green) / yellow.red, 0.05);
  EXPECT_GT(middle[1], 3 * middle[0]);
}

TEST(MeshThumbnail, OneSliverOfATriangleIsNoTrouble) {
  Triangles mesh;
  mesh.points_mm = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.corners.push_back({0, 1, 2});
  EXPECT_EQ(covered(mesh_thumbnail(mesh, 32)), 0.0);
}

}  // namespace
}  // namespace alltact::test
