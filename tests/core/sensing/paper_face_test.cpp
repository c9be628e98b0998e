// The source paper's edges and face, on pictures whose face is known by analytic geometry.
#include "core/sensing/paper_method.h"
#include "tests/support/cameras.h"
#include "tests/support/synthetic_face.h"

#include <cmath>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kNearest_mm = 60, kSlope = 0.5, kWidth_mm = 24;

/// z of a straight face z = z0 + slope x in a column, by hand.
double plane_z_mm(const CameraParameters& lens, double u) {
  return kNearest_mm / (1.0 - kSlope * (u - lens.cx_px) / lens.fx_px);
}

test::SyntheticFace drawn(const CameraParameters& lens) {
  test::SyntheticFace face;
  face.width = lens.width_px;
  face.height = lens.height_px;
  const auto half = [lens](double u) { return 0.5 * kWidth_mm * lens.fy_px / plane_z_mm(lens, u); };
  face.upper = [half, lens](double u) { return lens.cy_px - half(u); };
  face.lower = [half, lens](double u) { return lens.cy_px + half(u); };
  face.first_u = 40;
  face.last_u = 900;
  return face;
}

Face fin_ray() {
  Face face;
  face.width_mm = kWidth_mm;
  face.layer_mm = 1.5;
  return face;
}

TEST(PaperFace, EdgesAreThoseOfThePictureToHalfAPixel) {
  const CameraParameters lens = pinhole();
  const test::SyntheticFace face = drawn(lens);
  const PaperEdges edges = paper_edges(face.draw(3));
  EXPECT_NEAR(edges.seen, 861, 2);
  for (std::size_t u = 50; u < 890; ++u) {
    ASSERT_NEAR(edges.upper_v[u], face.upper(static_cast<double>(u)), 0.75) << u;
    ASSERT_NEAR(edges.lower_v[u], face.lower(static_cast<double>(u)), 0.75) << u;
  }
  EXPECT_TRUE(std::isnan(edges.upper_v[10]));
}

TEST(PaperFace, LightThatFallsTenfoldCutsNoTipOff) {
  const CameraParameters lens = pinhole();
  test::SyntheticFace face = drawn(lens);
  face.beside = 4;
  face.bright = [](double u) { return 220.0 * std::pow(10.0, -u / 960.0); };
  EXPECT_NEAR(paper_edges(face.draw(4)).seen, 861, 2);
}

TEST(PaperFace, ProfileIsThePlaneThatWasDrawn) {
  const CameraParameters lens = pinhole();
  const Camera camera = Camera::create(lens).value();
  const auto fitted = PaperFace::fit(paper_edges(drawn(lens).draw(5)), camera, fin_ray());
  ASSERT_TRUE(fitted.ok()) << fitted.error().sentence();
  const auto shape = fitted->shape(camera, fin_ray());
  ASSERT_TRUE(shape.ok()) << shape.error().sentence();
  for (std::size_t u = 60; u < 880; u += 20) {
    const double z_mm = fitted->z_mm()[u];
    EXPECT_NEAR(z_mm, plane_z_mm(lens, static_cast<double>(u)), 0.1) << u;
    const auto there = shape->at(static_cast<double>(u), lens.cy_px);
    ASSERT_TRUE(there) << u;
    EXPECT_NEAR(there->view_point_mm.z(), z_mm, 0.01) << u;
  }
}

TEST(PaperFace, APictureWithoutAFaceIsASentence) {
  const Camera camera = Camera::create(pinhole()).value();
  const auto none = PaperFace::fit(paper_edges(cv::Mat(camera.size(), CV_8UC1, cv::Scalar(90))),
                                   camera, fin_ray());
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().what.english().find("0 of 960 columns"), std::string::npos)
      << none.error().sentence();
}

}  // namespace
}  // namespace alltact
