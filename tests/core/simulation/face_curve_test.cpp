// Many lines at once against one by one, for faces bent a little, much, and beyond reason.
#include "core/simulation/face_curve.h"

#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

FaceCurve random_curve(Parameters& random, double length, double bend) {
  FaceCurve curve({random.between(-30, -20), random.between(-2, 2), random.between(25, 32)},
                  random.between(-0.2, 0.8), length);
  curve.bend(bend * random.between(-1, 1), bend * random.between(-1, 1));
  if (random.between(0, 1) < 0.5) curve.sway(random.between(-3, 3));
  curve.integrate();
  return curve;
}

TEST(FaceCurve, IsMetByManyLinesAsByEachOfThem) {
  Parameters random(61);
  int met = 0, missed = 0, turned_much = 0;
  for (int run = 0; run < 60; ++run) {
    const bool is_wild = run % 4 == 3;
    const double length = is_wild ? random.between(2, 60) : 116;
    const FaceCurve curve = random_curve(random, length, is_wild ? 100 : random.between(0, 25));
    std::vector<double> origins, directions;
    const bool parallel = run % 5 == 0;
    for (int u = 0; u < 500; ++u) {
      origins.push_back(parallel ? -40 + 0.25 * u : 0);
      directions.push_back(parallel ? 0 : -1.2 + 0.0048 * u);
    }
    const FaceCurve::Intersections all = curve.intersect_all(origins, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const double s = curve.intersect(origins[i], directions[i]);
      ASSERT_EQ(std::isnan(all.s_mm[i]), std::isnan(s)) << run << ' ' << i;
      const FaceCurve::Node p = curve.at(std::isnan(s) ? length : s);
      if (!std::isnan(s)) {
        EXPECT_NEAR(all.s_mm[i], s, 1e-11);
      }
      EXPECT_NEAR(all.x_mm[i], p.x_mm, 1e-11);
      EXPECT_NEAR(all.z_mm[i], p.z_mm, 1e-11);
      EXPECT_NEAR(all.x_s[i], p.x_s, 1e-13 + 1e-11 * std::abs(p.theta_s));
      EXPECT_NEAR(all.z_s[i], p.z_s, 1e-13 + 1e-11 * std::abs(p.theta_s));
      EXPECT_NEAR(all.shift_mm[i], p.shift_mm, 1e-11);
      met += !std::isnan(s);
      missed += std::isnan(s);
    }
    // Sine and cosine of the angle, however far it turns.
    for (double s = 0; s < length; s += length / 97) {
      const FaceCurve::Node p = curve.at(s);
      EXPECT_NEAR(p.x_s, std::cos(p.theta), 4e-16 + 2e-16 * std::abs(p.theta));
      EXPECT_NEAR(p.z_s, std::sin(p.theta), 4e-16 + 2e-16 * std::abs(p.theta));
      turned_much += std::abs(p.theta_s) * length / FaceCurve::kCells > 0.1;
    }
  }
  EXPECT_GT(met, 10000);
  EXPECT_GT(missed, 1000);
  EXPECT_GT(turned_much, 10);
}

// The curve's points by summing up its angle in small steps.
TEST(FaceCurve, IsWhereItsAngleLeads) {
  Parameters random(62);
  for (int run = 0; run < 6; ++run) {
    const double length = run % 2 == 0 ? 116 : random.between(3, 9),
                 incline = random.between(0, 0.7);
    const double q1 = random.between(-20, 20), q2 = random.between(-20, 20);
    FaceCurve curve({-25, 0, 28}, incline, length);
    curve.bend(q1, q2);
    curve.integrate();
    long double x = -25, z = 28;
    constexpr int kSteps = 200000;
    for (int i = 0; i < kSteps; ++i) {
      const long double t = (i + 0.5L) / kSteps, h = length / static_cast<long double>(kSteps);
      const long double theta = incline + (2 * q1 * t + q2 * (3 * t * t - 2 * t)) / length;
      x += h * std::cos(theta);
      z += h * std::sin(theta);
    }
    // What Gauss leaves of it grows with the sixth power of a cell's turn.
    const double bound = run % 2 == 0 ? 1e-8 : 1e-6;
    EXPECT_NEAR(curve.at(length).x_mm, static_cast<double>(x), bound);
    EXPECT_NEAR(curve.at(length).z_mm, static_cast<double>(z), bound);
  }
}

}  // namespace
}  // namespace alltact
