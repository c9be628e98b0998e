// A lens behind a flat window as one camera, held against light followed surface by surface.
#include "core/camera/camera.h"
#include "core/finger/finger_yaml.h"
#include "core/sensing/face/face_shape.h"
#include "tests/support/cameras.h"
#include "tests/support/temporary_folder.h"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace alltact {
namespace {

const FlatPort kPort{5, 3, 1.49, 1.41};

CameraParameters lens(CameraModel model, const FlatPort& port) {
  CameraParameters p = pinhole();
  p.model = model;
  if (model == CameraModel::kBrown) p.distortion = {-0.21, 0.07, 0.0008, -0.0005, -0.008};
  if (model == CameraModel::kFisheye) p.distortion = {0.012, -0.006, 0.003, -0.0006};
  p.port = port;
  return p;
}

Camera camera(CameraModel model = CameraModel::kPinhole, const FlatPort& port = kPort) {
  return Camera::create(lens(model, port)).value();
}

/// Snell's law with angles: the point at depth z that light from a direction in air reaches.
Eigen::Vector3d reached(const FlatPort& port, const Eigen::Vector3d& in_air, double z_mm) {
  const double way = std::atan2(in_air.y(), in_air.x());
  const double air = std::atan2(in_air.head<2>().norm(), in_air.z());
  const double r =
      port.gap_mm * std::tan(air) +
      port.plate_mm * std::tan(std::asin(std::sin(air) / port.plate_index)) +
      (z_mm - port.gap_mm - port.plate_mm) * std::tan(std::asin(std::sin(air) / port.medium_index));
  return {r * std::cos(way), r * std::sin(way), z_mm};
}

TEST(PortCamera, SeesWhereLightComesFrom) {
  for (const CameraModel model :
       {CameraModel::kPinhole, CameraModel::kBrown, CameraModel::kFisheye})
    for (const FlatPort& port : {kPort, FlatPort{1, 2, 1.52, 1.41}, FlatPort{10, 0, 1, 1.33},
                                 FlatPort{0, 5, 1.49, 1.41}}) {
      const Camera behind = camera(model, port);
      CameraParameters alone = behind.parameters();
      alone.port.reset();
      const Camera air = Camera::create(alone).value();
      for (double v = 0; v < 540; v += 49)
        for (double u = 0; u < 960; u += 53.2) {
          const auto in_air = air.unproject({u, v});
          const auto ray = behind.unproject({u, v});
          ASSERT_TRUE(in_air && ray);
          for (const double z : {25.0, 60.0, 100.0}) {
            const Eigen::Vector3d truth = reached(port, in_air->direction, z);
            EXPECT_LT((ray->point_at(z) - truth).norm(), 1e-11 * truth.norm());
            const auto pixel = behind.project(truth);
            ASSERT_TRUE(pixel);
            EXPECT_LT((*pixel - Eigen::Vector2d(u, v)).norm(), 1e-9);
          }
        }
    }
}

TEST(PortCamera, AWindowOfAirIsNone) {
  const Camera none = camera(CameraModel::kBrown, {5, 3, 1, 1});
  CameraParameters alone = none.parameters();
  alone.port.reset();
  const Camera air = Camera::create(alone).value();
  const Eigen::Vector3d point(11, -7, 55);
  EXPECT_LT((*none.project(point) - *air.project(point)).norm(), 1e-10);
  EXPECT_NEAR(none.mm_per_px_at(55), air.mm_per_px_at(55), 1e-14);
  EXPECT_NEAR(none.ray_origin_z_mm(55), 55, 1e-12);
  EXPECT_TRUE(air.is_central());
  EXPECT_FALSE(none.is_central());
}

TEST(PortCamera, AStepOfAPixelIsAsLongAsItSays) {
  const Camera behind = camera();
  for (const double z : {25.0, 60.0, 100.0}) {
    const auto a = behind.unproject({479.5, 269.0}), b = behind.unproject({479.5, 270.0});
    EXPECT_NEAR(behind.mm_per_px_at(z), (b->point_at(z) - a->point_at(z)).norm(), 1e-6);
  }
}

TEST(PortCamera, RefusesWindowsThatAreNone) {
  EXPECT_EQ(
      Camera::create(lens(CameraModel::kPinhole, {-1, 3, 1.49, 1.41})).error().where.english(),
      "camera.port.gap_mm");
  EXPECT_EQ(Camera::create(lens(CameraModel::kPinhole, {1, 3, 1.49, 9})).error().where.english(),
            "camera.port.medium_index");
  CameraParameters p = lens(CameraModel::kOrthographic, kPort);
  p.mm_per_px = 0.05;
  EXPECT_EQ(Camera::create(p).error().where.english(), "camera.port");
  EXPECT_FALSE(camera().project({1, 1, 7}));  // within the plate
}

TEST(PortCamera, IsKeptInItsFile) {
  const test::TemporaryFolder folder;
  const CameraParameters written = lens(CameraModel::kBrown, {5.25, 3, 1.491, 1.405});
  ASSERT_TRUE(save_camera(folder / "camera.yaml", written));
  const auto read = load_camera(folder / "camera.yaml");
  ASSERT_TRUE(read) << read.error().sentence();
  EXPECT_EQ(read->parameters, written);
}

/// The edges of a straight face, z = z0 + x tan(incline), that is 24 mm wide, as light through the
/// window draws them: by bisection along each column.
FaceEdges edges_through(const Camera& behind, double z0_mm, double slope) {
  FaceEdges edges;
  for (double u = 3.5; u < 960; u += 8.0) {
    edges.u.push_back(u);
    for (auto [edge, y] : {std::pair{&edges.upper, -12.0}, std::pair{&edges.lower, 12.0}}) {
      double low = -45, high = 60, v = 0;
      for (int step = 0; step < 60; ++step) {
        const double x = 0.5 * (low + high);
        const auto pixel = behind.project({x, y, z0_mm + slope * x});
        v = pixel ? pixel->y() : -1;
        (pixel && pixel->x() < u ? low : high) = x;
      }
      edge->v.push_back(v);
      edge->sd.push_back(0.05);
      edge->valid.push_back(v > 1 && v < 538 && high < 59.9 && low > -44.9);
    }
  }
  return edges;
}

// What a camera of one centre would be off by here: 0.6 mm rms at 100 mm, up to 0.8 mm.
TEST(PortCamera, TheFaceBehindAWindowIsWhereItIs) {
  Face face;
  face.width_mm = 24, face.layer_mm = 1.5;
  for (const auto& [z0, incline_deg] : {std::pair{55.0, 0.0}, {60.0, 25.0}, {70.0, 35.0}}) {
    const double slope = std::tan(incline_deg * M_PI / 180);
    const Camera behind = camera();
    const auto shape = FaceShape::fit(edges_through(behind, z0, slope), behind, face, 7);
    ASSERT_TRUE(shape) << shape.error().sentence();
    double worst = 0, worst_normal = 0;
    int seen = 0;
    for (int u = 0; u < 960; u += 7) {
      const auto rows = shape->rows(u, 3.0);
      for (int v = rows.first; v <= rows.last; v += 31) {
        const auto local = shape->at(u, v);
        if (!local) continue;
        const Eigen::Vector3d& p = local->view_point_mm;
        worst = std::max(worst, std::abs(p.z() - z0 - slope * p.x()));
        worst_normal = std::max(
            worst_normal, (local->normal - Eigen::Vector3d(-slope, 0, 1).normalized()).norm());
        EXPECT_LT((*behind.project(p) - Eigen::Vector2d(u, v)).norm(), 1e-7);
        ++seen;
      }
    }
    std::printf(
        "[ figures  ] face behind a window, %g degrees: off by %.4f mm at most, normal by "
        "%.5f, %d places\n",
        incline_deg, worst, worst_normal, seen);
    EXPECT_GT(seen, 500);
    EXPECT_LT(worst, 0.01);
    EXPECT_LT(worst_normal, 0.005);
    // A pixel's area is that between the points its corners see.
    const auto here = shape->at(480, 270), right = shape->at(480.5, 270),
               left = shape->at(479.5, 270), above = shape->at(480, 269.5),
               below = shape->at(480, 270.5);
    ASSERT_TRUE(here && right && left && above && below);
    const double area = (right->view_point_mm - left->view_point_mm)
                            .cross(below->view_point_mm - above->view_point_mm)
                            .norm();
    EXPECT_NEAR(shape->pixel_area(480, 270)->on_face_mm2, area, 0.01 * area);
  }
}

}  // namespace
}  // namespace alltact
