#include "core/sensing/face/face_edges.h"
#include "core/sensing/face/face_shape.h"
#include "tests/support/cameras.h"
#include "tests/support/synthetic_face.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using test::SyntheticFace;

/// A face with both ends in the picture, somewhere.
SyntheticFace face_with_ends(std::mt19937& engine) {
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  };
  SyntheticFace face;
  // A width that falls faster would be a face whose back is seen near the base.
  const double wide = draw(360, 440), narrow = draw(200, 270), sway = draw(-30, 30);
  const auto half = [=](double u) { return 0.5 / ((1 - u / 960) / wide + u / 960 / narrow); };
  face.upper = [=](double u) { return 270 + sway * u / 960 - half(u); };
  face.lower = [=](double u) { return 270 + sway * u / 960 + half(u); };
  const double near = draw(120, 220), far = draw(35, 70);
  face.bright = [=](double u) { return near + (far - near) * u / 960; };
  face.beside = draw(4, 15);
  face.blur_px = draw(0.0, 1.2);
  // Whole columns: the first and the last that show the face.
  face.first_u = std::floor(draw(20, 120)), face.last_u = std::floor(draw(600, 930));
  return face;
}

TEST(FaceEnds, AreFoundToAFewTenthsOfAPixel) {
  std::mt19937 engine(31);
  for (unsigned run = 0; run < 16; ++run) {
    const SyntheticFace face = face_with_ends(engine);
    const auto edges = FaceEdgeFinder()(face.draw(run));
    ASSERT_TRUE(edges.ok()) << edges.error().sentence();
    ASSERT_TRUE(edges->ends.first && edges->ends.last) << "run " << run;
    // A face of whole columns ends half a pixel beyond the middle of its last one.
    EXPECT_NEAR(edges->ends.first->at(270), face.first_u - 0.5, 0.2) << "run " << run;
    EXPECT_NEAR(edges->ends.last->at(270), face.last_u + 0.5, 0.2) << "run " << run;
    EXPECT_NEAR(edges->ends.last->slope, 0.0, 0.01) << "run " << run;
  }
}

TEST(FaceEnds, NothingBeyondThemIsFaceAndNothingWithinIsLost) {
  std::mt19937 engine(32);
  const Camera camera = Camera::create(pinhole()).value();
  Face fin_ray;
  fin_ray.width_mm = 24.0;
  for (unsigned run = 0; run < 8; ++run) {
    const SyntheticFace face = face_with_ends(engine);
    const auto edges = FaceEdgeFinder()(face.draw(run));
    ASSERT_TRUE(edges.ok());
    const auto shape = FaceShape::fit(*edges, camera, fin_ray, 7);
    ASSERT_TRUE(shape.ok()) << shape.error().sentence();
    for (int u = 0; u < 960; ++u) {
      const auto rows = shape->rows(u, 0.0);
      if (u < face.first_u - 1 || u > face.last_u + 1) {
        EXPECT_GT(rows.first, rows.last) << "run " << run << " column " << u;
      }
      if (u < face.first_u + 1 || u > face.last_u - 1) continue;
      EXPECT_LE(rows.first, std::ceil(face.upper(u) + 1.0)) << "run " << run << " column " << u;
      EXPECT_GE(rows.last, std::floor(face.lower(u) - 1.0)) << "run " << run << " column " << u;
    }
  }
}

TEST(FaceEnds, WhatPressesOnTheEndDoesNotMoveIt) {
  std::mt19937 engine(33);
  for (const double centre_part : {0.0, 0.5, 1.0}) {  // a corner, the middle, the other corner
    const SyntheticFace face = face_with_ends(engine);
    cv::Mat image = face.draw(5);
    const double v0 =
        face.upper(face.last_u) + centre_part * (face.lower(face.last_u) - face.upper(face.last_u));
    const double radius = 0.25 * (face.lower(face.last_u) - face.upper(face.last_u));
    for (int v = 0; v < image.rows; ++v)
      for (int u = 0; u < image.cols; ++u)
        if (v > face.upper(u) && v < face.lower(u) && u <= face.last_u &&
            std::hypot(u - face.last_u, v - v0) < radius)
          image.at<std::uint8_t>(v, u) = static_cast<std::uint8_t>(face.beside + 2);
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok());
    ASSERT_TRUE(edges->ends.last) << centre_part;
    EXPECT_NEAR(edges->ends.last->at(270), face.last_u + 0.5, 0.5) << centre_part;
  }
}

// The base of a finger lies near the picture's border, and in a reduced picture nearer.
TEST(FaceEnds, NearThePicturesBorderTheyAreFoundToo) {
  std::mt19937 engine(36);
  for (unsigned run = 0; run < 12; ++run) {
    SyntheticFace face = face_with_ends(engine);
    face.blur_px = 0.5;
    face.first_u = std::floor(std::uniform_real_distribution<double>(12, 20)(engine));
    const cv::Mat whole = face.draw(run);
    for (const int reduced_by : {1, 2, 4}) {
      cv::Mat image;
      cv::resize(whole, image, {}, 1.0 / reduced_by, 1.0 / reduced_by, cv::INTER_AREA);
      const auto edges = FaceEdgeFinder()(image);
      ASSERT_TRUE(edges.ok()) << edges.error().sentence();
      ASSERT_TRUE(edges->ends.first) << "run " << run << " reduced by " << reduced_by;
      const double found = edges->ends.first->at(0.5 * image.rows);
      EXPECT_NEAR(found, face.first_u / reduced_by - 0.5, 0.25)
          << "run " << run << " reduced by " << reduced_by;
    }
  }
}

TEST(FaceEnds, AFaceThatGoesOnToTheBorderHasNone) {
  std::mt19937 engine(34);
  SyntheticFace face = face_with_ends(engine);
  face.first_u = -10, face.last_u = 2000;
  const auto edges = FaceEdgeFinder()(face.draw(1));
  ASSERT_TRUE(edges.ok());
  EXPECT_FALSE(edges->ends.first);
  EXPECT_FALSE(edges->ends.last);
}

// Beside a border that leans, as where the finger twists.
TEST(FaceEnds, ThatLeanAreFoundSo) {
  std::mt19937 engine(35);
  SyntheticFace face = face_with_ends(engine);
  const double lean = 0.15, end = 700.0;
  face.last_u = 2000;
  cv::Mat image = face.draw(2);
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u) {
      const double covered = std::clamp(end + lean * (v - 270) - (u - 0.5), 0.0, 1.0);
      const double on = image.at<std::uint8_t>(v, u);
      if (v > face.upper(u) && v < face.lower(u))
        image.at<std::uint8_t>(v, u) =
            static_cast<std::uint8_t>(std::lround(face.beside + covered * (on - face.beside)));
    }
  const auto edges = FaceEdgeFinder()(image);
  ASSERT_TRUE(edges.ok());
  ASSERT_TRUE(edges->ends.last);
  EXPECT_NEAR(edges->ends.last->slope, lean, 0.01);
  EXPECT_NEAR(edges->ends.last->at(270), end, 0.2);
}

// A tip that leaves the picture shows a corner of the dark beyond it.
TEST(FaceEnds, ThatLeaveThePictureAreFoundByWhatIsInIt) {
  std::mt19937 engine(37);
  for (unsigned run = 0; run < 8; ++run) {
    SyntheticFace face = face_with_ends(engine);
    face.upper = [](double) { return 150.0; };
    face.lower = [](double) { return 390.0; };
    face.last_u = 2000;
    cv::Mat image = face.draw(run);
    const auto end = [](double v) { return 958.0 - 0.08 * (v - 270); };
    for (int v = 150; v < 390; ++v)
      for (int u = 900; u < image.cols; ++u) {
        const double covered = std::clamp(end(v) - (u - 0.5), 0.0, 1.0);
        const double on = image.at<std::uint8_t>(v, u);
        image.at<std::uint8_t>(v, u) =
            static_cast<std::uint8_t>(std::lround(face.beside + covered * (on - face.beside)));
      }
    const auto edges = FaceEdgeFinder()(image);
    ASSERT_TRUE(edges.ok());
    ASSERT_TRUE(edges->ends.last) << "run " << run;
    EXPECT_NEAR(edges->ends.last->at(360), end(360), 0.4) << "run " << run;
    EXPECT_NEAR(edges->ends.last->slope, -0.08, 0.02) << "run " << run;
  }
}

}  // namespace
}  // namespace alltact
