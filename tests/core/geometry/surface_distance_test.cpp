#include "core/geometry/surface_distance.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using Height = std::function<double(double x, double y)>;

/// A grid over [-half_x, half_x] x [-half_y, half_y], in float as measured surfaces are.
cv::Mat surface(int columns, int rows, double half_x, double half_y, const Height& z_mm) {
  cv::Mat grid(rows, columns, CV_32FC3);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = half_x * (2.0 * i / (columns - 1) - 1);
      const double y = half_y * (2.0 * j / (rows - 1) - 1);
      grid.at<cv::Vec3f>(j, i) = cv::Vec3d(x, y, z_mm(x, y));
    }
  return grid;
}
cv::Mat plane(double z_mm, int columns = 37, int rows = 11) {
  return surface(columns, rows, 50, 12, [=](double, double) { return z_mm; });
}

RigidTransform moved(const Eigen::Vector3d& degrees, const Eigen::Vector3d& by_mm) {
  return {rotation_from_rpy_deg(degrees), by_mm};
}

TEST(SurfaceDistance, OfTwoPlanesIsTheirDistance) {
  for (const double apart : {0.0, 0.125, 7.5, 400.0}) {
    const auto nearest = nearest_points({plane(10), {}}, {plane(10 + apart, 23, 30), {}});
    ASSERT_TRUE(nearest);
    EXPECT_NEAR(nearest->distance(), apart, 1e-9);
  }
}

TEST(SurfaceDistance, OfPlanesThatFaceEachOtherInTheGripper) {
  // Two cameras 80 mm apart look at each other; each face lies 30 mm before its camera.
  const PosedSurface left{plane(30), moved({0, 90, 0}, {-40, 0, 0})};
  const PosedSurface right{plane(30), moved({0, -90, 0}, {40, 0, 0})};
  const auto nearest = nearest_points(left, right);
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->distance(), 20, 1e-9);
  EXPECT_NEAR(nearest->first.x(), -10, 1e-9);
  EXPECT_NEAR(nearest->second.x(), 10, 1e-9);
}

TEST(SurfaceDistance, OfAWedgeIsThatOfItsEdge) {
  // A half plane's edge 5 mm over a plane; it rises from there by 20 degrees.
  const double tilt = 20;
  const cv::Mat above =
      surface(20, 9, 10, 6, [](double, double) { return 0.0; });  // its left edge at x = -10
  const double edge_z = 5 + 10 * std::sin(tilt * std::numbers::pi / 180);
  const auto nearest =
      nearest_points({plane(0), {}}, {above, moved({0, -tilt, 0}, {0, 0, edge_z})});
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->distance(), 5, 1e-6);
  EXPECT_NEAR(nearest->second.x(), -10 * std::cos(tilt * std::numbers::pi / 180), 1e-6);
}

TEST(SurfaceDistance, OfABallOverAPlane) {
  // Between its vertices a grid lies inside the ball, by a quarter of step^2 / R at most.
  const double radius = 30, step = 0.25;
  const cv::Mat cap = surface(161, 97, 20, 12, [&](double x, double y) {
    return 33 - std::sqrt(radius * radius - x * x - y * y);  // 3 mm over z = 0
  });
  const auto nearest = nearest_points({cap, {}}, {plane(0, 9, 5), {}});
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->distance(), 3, 1e-5);
  EXPECT_LT(std::hypot(nearest->first.x(), nearest->first.y()), step);
}

TEST(SurfaceDistance, IsNoneWhereTheyCross) {
  const PosedSurface flat{plane(0), {}};
  const PosedSurface upright{plane(0), moved({0, 90, 0}, {3.3, 0, 0})};
  const auto nearest = nearest_points(flat, upright);
  ASSERT_TRUE(nearest);
  EXPECT_LT(nearest->distance(), 1e-12);
  EXPECT_NEAR(nearest->first.x(), 3.3, 1e-9);
}

TEST(SurfaceDistance, LeavesOutWhatIsNotThere) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  cv::Mat holed = surface(21, 5, 10, 2, [](double x, double) { return x < 0 ? 1.0 : 4.0; });
  holed(cv::Rect(0, 0, 11, 5)).setTo(cv::Scalar::all(none));  // the near half
  const auto nearest = nearest_points({holed, {}}, {plane(0), {}});
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->distance(), 4, 1e-9);
  holed.setTo(cv::Scalar::all(none));
  EXPECT_FALSE(nearest_points({holed, {}}, {plane(0), {}}));
  EXPECT_FALSE(nearest_points({plane(0), {}}, {cv::Mat(1, 5, CV_32FC3, cv::Scalar()), {}}));
}

class AnyTwo : public testing::Test {
 protected:
  double uniform(double scale) { return std::uniform_real_distribution(-scale, scale)(random_); }
  cv::Mat rough(int columns, int rows) {
    return surface(columns, rows, 8, 5, [this](double, double) { return uniform(4); });
  }
  RigidTransform any() {
    return moved({uniform(180), uniform(90), uniform(180)},
                 {uniform(15), uniform(15), uniform(15)});
  }
  std::mt19937 random_{11};
};

/// Of every triangle with every other.
double by_trying_all(const PosedSurface& first, const PosedSurface& second) {
  const auto triangles = [](const PosedSurface& surface) {
    std::vector<Triangle> all;
    const auto at = [&](int j, int i) {
      const auto& p = surface.points_mm.at<cv::Vec3f>(j, i);
      return surface.pose.point({p[0], p[1], p[2]});
    };
    for (int j = 0; j + 1 < surface.points_mm.rows; ++j)
      for (int i = 0; i + 1 < surface.points_mm.cols; ++i) {
        all.push_back({at(j, i), at(j + 1, i), at(j, i + 1)});
        all.push_back({at(j, i + 1), at(j + 1, i), at(j + 1, i + 1)});
      }
    return all;
  };
  double best = std::numeric_limits<double>::infinity();
  for (const Triangle& p : triangles(first))
    for (const Triangle& q : triangles(second))
      best = std::min(best, nearest_points(p, q).distance());
  return best;
}

TEST_F(AnyTwo, IsWhatTryingEverythingGives) {
  for (int i = 0; i < 60; ++i) {
    const PosedSurface first{rough(7, 5), any()}, second{rough(4, 9), any()};
    const auto nearest = nearest_points(first, second);
    ASSERT_TRUE(nearest);
    const double truth = by_trying_all(first, second);
    EXPECT_NEAR(nearest->distance(), truth, 1e-8 * std::max(1.0, truth));
  }
}

TEST_F(AnyTwo, IsTheSameFromEverywhereAndEitherWay) {
  for (int i = 0; i < 30; ++i) {
    const PosedSurface first{rough(12, 7), any()}, second{rough(9, 8), any()};
    const double apart = nearest_points(first, second)->distance();
    EXPECT_NEAR(nearest_points(second, first)->distance(), apart, 1e-8);
    const RigidTransform there = any();
    const auto carried = [&](const PosedSurface& surface) {
      return PosedSurface{
          surface.points_mm,
          {there.rotation * surface.pose.rotation, there.point(surface.pose.translation_mm)}};
    };
    EXPECT_NEAR(nearest_points(carried(first), carried(second))->distance(), apart, 1e-8);
  }
}

/// Samples of both triangles are never nearer than what is said, and come close to it.
TEST_F(AnyTwo, TrianglesAgreeWithDenseSamples) {
  const auto corner = [this] { return Eigen::Vector3d(uniform(3), uniform(3), uniform(3)); };
  constexpr int kSteps = 24;
  const auto samples = [](const Triangle& t) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i <= kSteps; ++i)
      for (int j = 0; i + j <= kSteps; ++j)
        points.push_back(t[0] + double(i) / kSteps * (t[1] - t[0]) +
                         double(j) / kSteps * (t[2] - t[0]));
    return points;
  };
  for (int i = 0; i < 60; ++i) {
    const Triangle p{corner(), corner(), corner()}, q{corner(), corner(), corner()};
    double sampled = std::numeric_limits<double>::infinity();
    for (const auto& a : samples(p))
      for (const auto& b : samples(q)) sampled = std::min(sampled, (b - a).norm());
    const double reported = nearest_points(p, q).distance();
    EXPECT_LE(reported, sampled + 1e-12);
    EXPECT_GT(reported, sampled - 0.5) << "steps are up to 10 / 24 mm long";
  }
}

}  // namespace
}  // namespace alltact
