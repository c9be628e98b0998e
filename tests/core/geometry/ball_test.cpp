#include "core/geometry/ball.h"

#include "core/geometry/circle_fit.h"
#include "tests/support/cameras.h"

#include <cmath>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using Long3 = Eigen::Matrix<long double, 3, 1>;

TEST(Ball, GrazingRaysKeepTheirDigits) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double grazing : {0.5, 1e-2, 1e-4}) {
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d u = Eigen::Vector3d(uniform(random), uniform(random), 2.0);
      const Eigen::Vector3d aside = u.unitOrthogonal();
      const double radius = 3.0;
      const Eigen::Vector3d centre = u.normalized() * 40.0 + aside * (radius * (1.0 - grazing));
      const auto hit = intersect_ball({Eigen::Vector3d::Zero(), u}, centre, radius);
      ASSERT_TRUE(hit);
      const Long3 ul = u.cast<long double>(), cl = centre.cast<long double>();
      const long double a = ul.squaredNorm(), b = ul.dot(cl);
      const long double disc = b * b - a * (cl.squaredNorm() - 9.0L);
      const long double near = (b - std::sqrt(disc)) / a;
      // Rounding of the centre's own digits moves a grazing root by eps |c| / sqrt(2 grazing) / R.
      EXPECT_NEAR(hit->near, static_cast<double>(near), 1e-13 * hit->near / std::sqrt(grazing));
      EXPECT_GE(hit->far, hit->near);
    }
  }
}

TEST(Ball, LinesThatMissHitNothing) {
  EXPECT_FALSE(intersect_ball({{0, 0, 0}, {0, 0, 1}}, {3.0 + 1e-12, 0, 40}, 3.0));
  EXPECT_TRUE(intersect_ball({{0, 0, 0}, {0, 0, 1}}, {3.0 - 1e-12, 0, 40}, 3.0));
  EXPECT_FALSE(intersect_ball({{0, 0, 0}, {0, 0, 0}}, {0, 0, 40}, 3.0));
  const auto behind = intersect_ball({{0, 0, 0}, {0, 0, 1}}, {0, 0, -40}, 3.0);
  ASSERT_TRUE(behind);
  EXPECT_NEAR(behind->near, -43.0, 1e-12);
  EXPECT_NEAR(behind->far, -37.0, 1e-12);
}

TEST(Ball, AnglesKeepTheirDigitsDownToNothing) {
  const Eigen::Vector3d c(5.0, -7.0, 40.0);
  const Eigen::Vector3d across = c.unitOrthogonal();
  for (double alpha = 1e-12; alpha < 1.5; alpha *= 3.0) {
    const Eigen::Vector3d p = c.normalized() * std::cos(alpha) + across * std::sin(alpha);
    const Eigen::Vector3d on_plane = c + across * (c.norm() * std::tan(alpha));
    const Long3 pl = on_plane.cast<long double>(), cl = c.cast<long double>();
    const long double exact = std::atan2((pl - cl).cross(cl).norm(), pl.dot(cl));
    EXPECT_NEAR(angle_between(on_plane, c), static_cast<double>(exact),
                8.0 * 2.2e-16 * alpha + 8.0 * 2.2e-16 * c.norm() * 2.2e-16)
        << alpha;
    EXPECT_NEAR(sine_between(on_plane, c), std::sin(static_cast<double>(exact)),
                16.0 * 2.2e-16 * alpha)
        << alpha;
    EXPECT_TRUE(std::isfinite(sine_between(p, c)));
  }
}

TEST(Ball, HorizonIsWhereRaysGraze) {
  const Eigen::Vector3d c(12.0, -9.0, 40.0);
  for (const auto& p : ball_horizon_mm(true, c, 3.0, 36)) {
    EXPECT_NEAR((p - c).norm(), 3.0, 1e-13);
    EXPECT_NEAR((p - c).dot(p), 0.0, 1e-11);
  }
  for (const auto& p : ball_horizon_mm(false, c, 3.0, 36)) EXPECT_NEAR(p.z(), 40.0, 1e-13);
  EXPECT_TRUE(ball_horizon_mm(true, {0, 0, 1}, 3.0, 8).empty());
}

TEST(Ball, OutlineIsTheEllipseNotACircle) {
  // f = 1000 px, R = 3 mm, 40 mm away along a ray 30 degrees off the axis.
  const double theta = M_PI / 6.0;
  const Eigen::Vector3d c(40.0 * std::tan(theta), 0.0, 40.0);
  const auto ellipse = ball_ellipse(c, 3.0);
  ASSERT_TRUE(ellipse);
  EXPECT_NEAR(1000.0 * ellipse->long_axis, 86.9, 0.1);
  EXPECT_NEAR(1000.0 * ellipse->short_axis, 75.2, 0.1);
  EXPECT_NEAR(1000.0 * (ellipse->centre.x() - c.x() / c.z()), 3.27, 0.02);
  CameraParameters parameters;
  parameters.width_px = 1920;
  parameters.height_px = 1080;
  parameters.fx_px = parameters.fy_px = 1000.0;
  parameters.cx_px = 960.0;
  parameters.cy_px = 540.0;
  const Camera camera = Camera::create(parameters).value();
  const auto outline = ball_outline_px(camera, c, 3.0, 100);
  ASSERT_EQ(outline.size(), 100U);
  for (const auto& p : outline) {
    const double x = ((p.x() - 960.0) / 1000.0 - ellipse->centre.x()) / ellipse->long_axis;
    const double y = ((p.y() - 540.0) / 1000.0 - ellipse->centre.y()) / ellipse->short_axis;
    EXPECT_NEAR(std::hypot(x, y), 1.0, 1e-12);
  }
  EXPECT_GT(fit_circle(outline)->rms, 3.0);
  EXPECT_FALSE(ball_ellipse({40.0, 0.0, 2.9}, 3.0));
}

std::vector<Eigen::Vector3d> outline_arc(const Eigen::Vector3d& c, double radius, double start_deg,
                                         double arc_deg, double noise_px, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector3d> directions;
  const double alpha = std::asin(radius / c.norm());
  const Eigen::Vector3d first = c.unitOrthogonal();
  const Eigen::Vector3d second = c.normalized().cross(first);
  for (double a = 0; a <= arc_deg; a += 1.0 / 1.5) {
    const double turn = (start_deg + a) * M_PI / 180.0;
    Eigen::Vector3d u = std::cos(alpha) * c.normalized() +
                        std::sin(alpha) * (std::cos(turn) * first + std::sin(turn) * second);
    u /= u.z();
    directions.emplace_back(u.x() + noise_px / 1000.0 * normal(random),
                            u.y() + noise_px / 1000.0 * normal(random), 1.0);
  }
  return directions;
}

TEST(Ball, ExactOutlineGivesTheBall) {
  std::mt19937 random(4);
  for (double theta = 0.0; theta <= 42.0; theta += 6.0) {
    for (const double span : {40.0, 90.0, 200.0, 359.0}) {
      const double t = theta * M_PI / 180.0;
      const Eigen::Vector3d c(40.0 * std::sin(t), 5.0, 40.0 * std::cos(t));
      const auto ball =
          fit_ball_to_outline(outline_arc(c, 3.0, 33.0 + theta, span, 0.0, random), 3.0);
      ASSERT_TRUE(ball);
      // The direction cosines carry eps; a 40 degree arc magnifies it some hundred times.
      EXPECT_LT((*ball - c).norm() / c.norm(), 1e-12) << theta << " " << span;
    }
  }
}

TEST(Ball, OutlineIsWhereLinesOfSightTouchWhateverTheyComeThrough) {
  CameraParameters lens = pinhole();
  const Eigen::Vector3d c(12.0, -7.0, 48.0);
  for (const bool has_window : {false, true}) {
    if (has_window) lens.port = FlatPort{5.0, 3.0, 1.49, 1.41};
    const Camera camera = Camera::create(lens).value();
    const auto outline = ball_outline_px(camera, c, 4.0, 36);
    ASSERT_EQ(outline.size(), 36U);
    for (const auto& pixel : outline) {
      const Ray ray = camera.unproject(pixel).value();
      const Eigen::ParametrizedLine<double, 3> line(ray.origin_mm, ray.direction.normalized());
      EXPECT_NEAR(line.distance(c), 4.0, 1e-8) << "window: " << has_window;
    }
  }
}

TEST(Ball, NoisyOutlineIsUnbiased) {
  std::mt19937 random(5);
  const Eigen::Vector3d c(0.0, 0.0, 40.0);
  constexpr int kRuns = 1000;
  double sum = 0, square = 0;
  for (int i = 0; i < kRuns; ++i) {
    const auto ball = fit_ball_to_outline(outline_arc(c, 3.0, 0.0, 90.0, 0.5, random), 3.0);
    ASSERT_TRUE(ball);
    sum += ball->z() - 40.0;
    square += std::pow(ball->z() - 40.0, 2);
  }
  const double bias = sum / kRuns;
  const double sd = std::sqrt(square / kRuns - bias * bias);
  EXPECT_LT(std::abs(bias), 0.05);
  EXPECT_NEAR(sd, 0.25, 0.15 * 0.25);
}

TEST(Ball, TooFewOrParallelDirectionsGiveNoBall) {
  EXPECT_FALSE(fit_ball_to_outline({{0, 0, 1}, {0.1, 0, 1}}, 3.0));
  EXPECT_FALSE(fit_ball_to_outline({{0, 0, 1}, {0.1, 0, 1}, {0.2, 0, 1}}, 3.0));
}

}  // namespace
}  // namespace alltact
