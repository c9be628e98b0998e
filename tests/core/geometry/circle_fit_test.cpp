#include "core/geometry/circle_fit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

std::vector<Eigen::Vector2d> arc(const Eigen::Vector2d& centre, double radius, double start_deg,
                                 double arc_deg, int count, double noise, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = (start_deg + arc_deg * i / (count - 1)) * M_PI / 180.0;
    points.emplace_back(centre + (radius + noise * normal(random)) *
                                     Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

TEST(CircleFit, ExactDataGiveTheCircle) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d centre(500.0 * uniform(random), 500.0 * uniform(random));
    const double radius = 75.0 + 70.0 * uniform(random);
    const double span = 200.0 + 155.0 * uniform(random);
    const auto points = arc(centre, radius, 180.0 * uniform(random), span, 40, 0.0, random);
    for (const auto& circle : {fit_circle_taubin(points), fit_circle(points)}) {
      ASSERT_TRUE(circle);
      EXPECT_NEAR(circle->radius, radius, 1e-10 * radius) << span;
      EXPECT_LT((circle->centre - centre).norm(), 1e-10 * (radius + centre.norm())) << span;
    }
  }
}

TEST(CircleFit, ThreePointsAreMetExactly) {
  const auto circle = fit_circle({{3.0, 0.0}, {0.0, 4.0}, {-1.0, -2.0}});
  ASSERT_TRUE(circle);
  EXPECT_LT(circle->rms, 1e-12);
}

TEST(CircleFit, LinesAndSpecksAreNoCircle) {
  EXPECT_FALSE(fit_circle({{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
  EXPECT_FALSE(fit_circle({{5, 5}, {5, 5}, {5, 5}}));
  EXPECT_FALSE(fit_circle({{0, 0}, {1, 1}}));
  EXPECT_FALSE(fit_circle({}));
  EXPECT_FALSE(fit_circle({{0, 0}, {1, NAN}, {2, 0}, {3, 1}}));
}

TEST(CircleFit, ShortArcsAreNotShrunk) {
  std::mt19937 random(2);
  for (const double span : {180.0, 90.0, 60.0}) {
    double sum = 0, square = 0;
    constexpr int kRuns = 1500;
    for (int i = 0; i < kRuns; ++i) {
      const auto circle = fit_circle(arc({20, -30}, 75.0, 10.0, span, 90, 0.5, random));
      ASSERT_TRUE(circle);
      sum += circle->radius - 75.0;
      square += std::pow(circle->radius - 75.0, 2);
    }
    const double bias = sum / kRuns;
    const double sd = std::sqrt(square / kRuns - bias * bias);
    EXPECT_LT(std::abs(bias), 0.1 * sd + 3.0 * sd / std::sqrt(kRuns)) << span;
  }
}

TEST(CircleFit, RefinedIsNeverFurtherFromThePoints) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const auto points = arc({1, 2}, 10.0, 3.6 * i, 60.0 + 2.5 * i, 30, 0.3, random);
    EXPECT_LE(fit_circle(points)->rms, fit_circle_taubin(points)->rms * (1.0 + 1e-12));
  }
}

}  // namespace
}  // namespace alltact
