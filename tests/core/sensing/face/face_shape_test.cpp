#include "core/sensing/face/face_shape.h"

#include "tests/support/cameras.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A face that is a plane: 1/z is linear in x exactly. z = z0 + m X.
struct Plane {
  double z0 = 55.0, m = 0.55, width = 24.0, shift_y = 1.5;
  [[nodiscard]] double z(double x) const { return z0 / (1.0 - m * x); }
};

/// Exact edges of a plane as any camera model sees them, by projecting points of both edges.
FaceEdges edges_of(const Plane& plane, const Camera& camera, double noise_sd, unsigned seed) {
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  FaceEdges edges;
  for (double u = 3.5; u < camera.size().width; u += 8.0) {
    edges.u.push_back(u);
    for (const double side : {-1.0, 1.0}) {
      // bisection for the point of this edge that projects to column u
      double low = -1.3, high = 1.3;
      Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
      for (int i = 0; i < 80; ++i) {
        const double x = 0.5 * (low + high);
        const double z = plane.z(x);
        pixel = *camera.project({x * z, plane.shift_y + side * 0.5 * plane.width, z});
        (pixel.x() < u ? low : high) = x;
      }
      Edge& edge = side < 0.0 ? edges.upper : edges.lower;
      edge.v.push_back(pixel.y() + (noise_sd > 0.0 ? noise_sd * noise(engine) : 0.0));
      edge.sd.push_back(std::max(noise_sd, 0.02));
      edge.valid.push_back(pixel.y() > 1.0 && pixel.y() < camera.size().height - 2.0);
    }
  }
  return edges;
}

Face fin_ray() {
  Face face;
  face.width_mm = 24.0;
  face.layer_mm = 1.5;
  return face;
}

TEST(FaceShape, APlaneComesBackExactly) {
  const Camera camera = Camera::create(pinhole()).value();
  const Plane plane;
  const auto shape = FaceShape::fit(edges_of(plane, camera, 0.0, 1), camera, fin_ray(), 7);
  ASSERT_TRUE(shape.ok()) << shape.error().sentence();
  EXPECT_TRUE(shape->base_at_low_u());
  int seen = 0;
  for (int u = 0; u < 960; ++u) {
    const auto local = shape->at(u, 300.0);
    if (!local) continue;
    ++seen;
    const double x = (u - 479.5) / 523.9;
    EXPECT_NEAR(local->view_point_mm.z() / plane.z(x), 1.0, 1e-5);  // 1 um
    const Eigen::Vector3d normal = Eigen::Vector3d(-plane.m, 0.0, 1.0).normalized();
    EXPECT_LT((local->normal - normal).norm(), 1e-3);
  }
  EXPECT_GT(seen, 700);
}

/// A face along a circle: the edges are steep where it is far.
TEST(FaceShape, ABentFaceComesBackToItsEnds) {
  const Camera camera = Camera::create(pinhole()).value();
  for (const double bend : {-0.5, 0.0, 0.3}) {  // radians more at the tip
    constexpr int kSteps = 4000;
    constexpr double kLength = 80.0;
    std::vector<Eigen::Vector3d> points;  // u, half width in px, z
    double x = -22.0, z = 36.0;
    for (int i = 0; i <= kSteps; ++i) {
      points.emplace_back(479.5 + 523.9 * x / z, 523.9 * 12.0 / z, z);
      const double angle = 0.55 + bend * i / kSteps;
      x += std::cos(angle) * kLength / kSteps, z += std::sin(angle) * kLength / kSteps;
    }
    const auto at = [&](double u) {
      const auto right = std::find_if(points.begin() + 1, points.end() - 1,
                                      [&](const auto& p) { return p.x() > u; });
      const Eigen::Vector3d a = *(right - 1), b = *right;
      return Eigen::Vector3d(a + (b - a) * (u - a.x()) / (b.x() - a.x()));
    };
    FaceEdges edges;
    for (double u = 3.5; u < 960; u += 8.0) {
      const double half = at(u).y();
      const bool seen = u > points.front().x() + 4 && u < points.back().x() - 4;
      edges.u.push_back(u);
      for (Edge* edge : {&edges.upper, &edges.lower}) {
        edge->v.push_back(269.5 + (edge == &edges.upper ? -half : half));
        edge->sd.push_back(0.03);
        edge->valid.push_back(seen);
      }
    }
    edges.ends.first = FaceEnd{points.front().x(), 269.5, 0.0, 0.05};
    edges.ends.last = FaceEnd{points.back().x(), 269.5, 0.0, 0.05};
    const auto shape = FaceShape::fit(edges, camera, fin_ray(), 7);
    ASSERT_TRUE(shape.ok()) << shape.error().sentence();
    for (int u = static_cast<int>(points.front().x()) + 1; u < points.back().x(); ++u) {
      const FaceColumn& column = shape->columns()[static_cast<std::size_t>(u)];
      ASSERT_TRUE(column.valid) << "bend " << bend << " column " << u;
      // Nearest to the tip a column is up to 0.4 mm of z, and beyond the last sample.
      const double to_tip_px = points.back().x() - u;
      const double bound_mm = to_tip_px > 60 ? 0.05 : to_tip_px > 12 ? 0.2 : 0.5;
      EXPECT_NEAR(column.z_mm, at(u).z(), bound_mm) << "bend " << bend << " column " << u;
    }
  }
}

TEST(FaceShape, DistortedLensesGiveTheSameFace) {
  for (const bool fisheye : {false, true}) {
    CameraParameters p = pinhole();
    p.model = fisheye ? CameraModel::kFisheye : CameraModel::kBrown;
    p.distortion = fisheye ? std::vector<double>{-0.02, 0.004, -0.002, 0.0003}
                           : std::vector<double>{-0.18, 0.05, 0.0004, -0.0003, -0.004};
    const Camera camera = Camera::create(p).value();
    const Plane plane;
    const auto shape = FaceShape::fit(edges_of(plane, camera, 0.0, 1), camera, fin_ray(), 7);
    ASSERT_TRUE(shape.ok()) << shape.error().sentence();
    int seen = 0;
    for (int u = 40; u < 920; u += 11) {
      for (int v = 180; v < 360; v += 45) {
        const auto local = shape->at(u, v);
        if (!local) continue;
        ++seen;
        const Eigen::Vector3d& q = local->view_point_mm;
        EXPECT_NEAR(q.z(), plane.z0 + plane.m * q.x(), 0.03) << u << ' ' << v;
      }
    }
    EXPECT_GT(seen, 150);
  }
}

// The end of a face that darkens towards its tip may be seen where its edges are lost long before.
TEST(FaceShape, AnEndSeenFarBeyondTheEdgesLeavesTheRestAlone) {
  CameraParameters p = pinhole();
  p.model = CameraModel::kFisheye;
  p.distortion = {-0.026, -0.011, -0.004, 0.0};
  const Camera camera = Camera::create(p).value();
  const Plane plane;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    FaceEdges edges = edges_of(plane, camera, 0.1, seed);
    for (Edge* edge : {&edges.upper, &edges.lower})
      for (std::size_t i = 0; i < edges.u.size(); ++i)
        if (edges.u[i] > 640.0) edge->valid[i] = 0;
    edges.ends.last = FaceEnd{860.0, 269.5, 0.0, 0.05};
    const auto shape = FaceShape::fit(edges, camera, fin_ray(), 7);
    ASSERT_TRUE(shape.ok()) << shape.error().sentence();
    int seen = 0;
    for (int u = 60; u < 600; u += 11) {
      const auto local = shape->at(u, 269.5);
      if (!local) continue;
      ++seen;
      const Eigen::Vector3d& q = local->view_point_mm;
      EXPECT_NEAR(q.z(), plane.z0 + plane.m * q.x(), 0.25) << "seed " << seed << " column " << u;
    }
    EXPECT_GT(seen, 40);
  }
}

// Bright dots next to the edges may draw the traced edges outwards at the tip.
TEST(FaceShape, EdgesDrawnOutwardsAtTheirEndDoNotStretchDepthAlongZ) {
  const Camera camera = Camera::create(pinhole()).value();
  constexpr std::size_t kDrawn = 16;  // windows
  for (const double slope : {0.55, 0.9})
    for (const double drawn_px : {8.0, 15.0, 30.0})
      for (unsigned seed = 1; seed <= 10; ++seed) {
        Plane plane;
        plane.m = slope;
        FaceEdges edges = edges_of(plane, camera, 0.1, seed);
        std::size_t last = edges.u.size() - 1;
        while (!edges.upper.valid[last]) --last;
        for (std::size_t k = 0; k < kDrawn; ++k) {
          const double off_px = drawn_px * std::pow(1.0 - static_cast<double>(k) / kDrawn, 2);
          edges.upper.v[last - k] -= off_px;
          edges.lower.v[last - k] += off_px;
        }
        const auto shape = FaceShape::fit(edges, camera, fin_ray(), kDefaultProfileDegree);
        ASSERT_TRUE(shape.ok()) << shape.error().sentence();
        int valid = 0;
        for (int u = 0; u < shape->width_px(); ++u) {
          const auto i = static_cast<std::size_t>(u);
          if (!shape->columns()[i].valid) continue;
          ++valid;
          ASSERT_LE(std::abs(shape->along_z_per_normal()[i]),
                    1.0 / std::cos(75 * M_PI / 180) + 1e-6)
              << slope << ' ' << drawn_px << ' ' << seed << ' ' << u;
        }
        EXPECT_GT(valid, 600);
      }
}

TEST(FaceShape, PromisesTheErrorItMakes) {
  const Camera camera = Camera::create(pinhole()).value();
  const Plane plane;
  constexpr double kModelPx = 0.03;  // of the width, which real edges are off by and these are not
  constexpr int kRuns = 200;
  const std::vector<int> places{200, 420, 640, 800};
  double sum = 0;
  for (unsigned run = 0; run < kRuns; ++run) {
    const auto shape = FaceShape::fit(edges_of(plane, camera, 0.3, 10 + run), camera, fin_ray(), 7);
    ASSERT_TRUE(shape.ok());
    for (const int u : places) {
      const FaceColumn& column = shape->columns()[static_cast<std::size_t>(u)];
      const double truth = plane.z((u - 479.5) / 523.9);
      const double off = column.z_mm - truth;
      const double model_mm = column.z_mm * kModelPx / (column.lower_v - column.upper_v);
      EXPECT_LT(std::abs(off), 0.25) << u;
      sum += off * off / (column.z_sd_mm * column.z_sd_mm - model_mm * model_mm);
    }
  }
  // What ends and Tukey's weights leave room for: never less than is promised, a fifth too much.
  const double told = sum / (kRuns * static_cast<double>(places.size()));
  EXPECT_LT(told, 1.15);
  EXPECT_GT(told, 0.7);
}

TEST(FaceShape, LayerIsAsThickAsItIsAtAnySlope) {
  const Camera camera = Camera::create(pinhole()).value();
  for (const double m : {-0.6, -0.2, 0.0, 0.3, 0.8}) {
    Plane plane;
    plane.m = m;
    const auto shape = FaceShape::fit(edges_of(plane, camera, 0.0, 1), camera, fin_ray(), 5);
    ASSERT_TRUE(shape.ok());
    const auto local = shape->at(450.0, 280.0);
    ASSERT_TRUE(local);
    const Eigen::Vector3d normal = untouched_point_mm(*local, 1.5, MappingAlong::kNormal);
    EXPECT_NEAR((normal - local->view_point_mm).norm(), 1.5, 4e-15 * 100.0);
    // both places lie on the same plane, parallel to the face
    const Eigen::Vector3d along_z = untouched_point_mm(*local, 1.5, MappingAlong::kZ);
    EXPECT_NEAR(local->normal.dot(along_z - normal), 0.0, 1e-12);
  }
}

TEST(FaceShape, AreaOfThePixelsIsTheAreaOfTheFace) {
  const Camera camera = Camera::create(pinhole()).value();
  const Plane plane;
  const auto shape = FaceShape::fit(edges_of(plane, camera, 0.0, 1), camera, fin_ray(), 7);
  ASSERT_TRUE(shape.ok());
  double area = 0, flat = 0, first = 1e9, last = -1e9;
  for (int u = 500; u < 800; ++u) {
    for (int v = 230; v < 310; ++v) {
      const auto pixel = shape->pixel_area(u, v);
      ASSERT_TRUE(pixel);
      area += pixel->on_face_mm2;
      flat += pixel->projected_mm2;
    }
  }
  // the same trapezium from its corners, between pixel borders
  const auto corner = [&](double u, double v) {
    const double x = (u - 479.5) / 523.9, y = (v - 269.5) / 523.9, z = plane.z(x);
    return Eigen::Vector3d(x * z, y * z, z);
  };
  const Eigen::Vector3d a = corner(499.5, 229.5), b = corner(799.5, 229.5);
  const Eigen::Vector3d c = corner(799.5, 309.5), d = corner(499.5, 309.5);
  const Eigen::Vector3d cross = 0.5 * (c - a).cross(d - b);
  EXPECT_NEAR(area / cross.norm(), 1.0, 1e-4);
  EXPECT_NEAR(flat / std::abs(cross.z()), 1.0, 1e-4);
  first = shape->length_at(500.0), last = shape->length_at(799.0);
  const Eigen::Vector3d p = corner(500.0, 269.5), q = corner(799.0, 269.5);
  EXPECT_NEAR(std::abs(last - first), std::hypot(p.x() - q.x(), p.z() - q.z()), 1e-3);
}

TEST(FaceShape, AnEdgeHiddenForAStretchWidensTheErrorThere) {
  const Camera camera = Camera::create(pinhole()).value();
  FaceEdges edges = edges_of({}, camera, 0.05, 3);
  for (std::size_t i = 55; i < 70; ++i) edges.upper.valid[i] = 0;
  const auto shape = FaceShape::fit(edges, camera, fin_ray(), 7);
  ASSERT_TRUE(shape.ok());
  const FaceColumn& hidden = shape->columns()[500];
  const FaceColumn& seen = shape->columns()[350];
  ASSERT_TRUE(hidden.valid);
  EXPECT_GT(hidden.z_sd_mm / hidden.z_mm, seen.z_sd_mm / seen.z_mm);
  EXPECT_NEAR(hidden.z_mm, Plane{}.z((500 - 479.5) / 523.9), 4.0 * hidden.z_sd_mm + 0.02);
}

TEST(FaceShape, TooLittleToGoByIsAnError) {
  const Camera camera = Camera::create(pinhole()).value();
  FaceEdges edges = edges_of({}, camera, 0.05, 3);
  std::fill(edges.upper.valid.begin(), edges.upper.valid.end() - 10, 0);
  EXPECT_FALSE(FaceShape::fit(edges, camera, fin_ray(), 7).ok());
  FaceEdges apart = edges_of({}, camera, 0.05, 3);
  std::fill(apart.upper.valid.begin(), apart.upper.valid.begin() + 60, 0);
  std::fill(apart.lower.valid.begin() + 60, apart.lower.valid.end(), 0);
  EXPECT_FALSE(FaceShape::fit(apart, camera, fin_ray(), 7).ok());
}

TEST(FaceShape, PlaneOfAFlatSensor) {
  CameraParameters p;
  p.model = CameraModel::kOrthographic;
  p.width_px = 460, p.height_px = 345;
  p.cx_px = 229.5, p.cy_px = 172.0;
  p.mm_per_px = 0.05;
  Face face;
  face.kind = FaceKind::kFlat;
  face.layer_mm = 2.0;
  face.plane_z_mm = 12.0;
  const FaceShape shape = FaceShape::plane(Camera::create(p).value(), face);
  EXPECT_EQ(shape.rows(10, 2.0).first, 0);
  EXPECT_EQ(shape.rows(459, 2.0).last, 344);
  const auto local = shape.at(249.5, 172.0);
  ASSERT_TRUE(local);
  EXPECT_LT((local->view_point_mm - Eigen::Vector3d(1.0, 0.0, 12.0)).norm(), 1e-12);
  EXPECT_DOUBLE_EQ(shape.pixel_area(249.5, 172.0)->on_face_mm2, 0.0025);
  EXPECT_NEAR(shape.length_at(100) - shape.length_at(0), 5.0, 1e-9);
}

}  // namespace
}  // namespace alltact
