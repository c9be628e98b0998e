// How far, and into which shape, a finger gives way to a press.
#include "tests/core/simulation/scene_text.h"

#include <cmath>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

const std::string kDots =
    "  - {use: sides, albedo: 0.1, depth_mm: 9}\n"
    "  - {use: markers, radius_mm: 1, setback_mm: 4, first: 0.1, last: 0.9, albedo: 1}\n";

std::string ball(double s_mm, const std::string& more) {
  return fmt::format("  - {{use: ball, radius_mm: 4, s_mm: {}, y_mm: 0, depth_mm: 0.5{}}}\n", s_mm,
                     more);
}

/// The mix of the two modes that a force at t = a makes, by least elastic energy, summed up in
/// small steps along the beam.
Eigen::Vector2d modes_of_force_at(double a) {
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    const double t = (i + 0.5) / kSteps;
    const Eigen::Vector2d curvature(2.0, 6.0 * t - 2.0);
    stiffness += curvature * curvature.transpose() / kSteps;
  }
  return stiffness.ldlt().solve(Eigen::Vector2d(a * a, a * a * a - a * a));
}

TEST(Give, TheFingerTakesTheShapeThatAForceAtThePressGivesABeam) {
  for (const double s : {20.0, 58.0, 100.0}) {
    const Truth given = plan_of(scene_text(kDots + ball(s, ", give_mm: 3"))).truth(0);
    Eigen::Vector2d q = modes_of_force_at(s / 116.0);
    q *= -3.0 / q.x();
    const std::string bend =
        "  - {use: bend, q1_mm: {from: -9, to: 9}, q2_mm: {from: -9, to: 9}}\n";
    const std::string pose = fmt::format(
        "motion: {{kind: hold, pose: {{q1_mm: {:.9f}, q2_mm: {:.9f}}}}}\n", q.x(), q.y());
    const Truth bent = plan_of(pose + scene_text(bend + kDots)).truth(0);
    const Truth rest = plan_of(scene_text(kDots)).truth(0);
    ASSERT_EQ(given.markers.size(), bent.markers.size());
    double towards_tip = 0;
    for (std::size_t m = 0; m < given.markers.size(); ++m) {
      EXPECT_NEAR(given.markers[m].u, bent.markers[m].u, 1e-5);
      EXPECT_NEAR(given.markers[m].v, bent.markers[m].v, 1e-5);
      towards_tip += given.markers[m].u - rest.markers[m].u;
    }
    EXPECT_GT(towards_tip, 5.0) << s;
  }
}

TEST(Give, WithoutTheKeyTheFingerStandsFirm) {
  const Truth pressed = plan_of(scene_text(kDots + ball(58, ""))).truth(0);
  const Truth rest = plan_of(scene_text(kDots)).truth(0);
  for (std::size_t m = 0; m < rest.markers.size(); ++m) {
    EXPECT_EQ(pressed.markers[m].u, rest.markers[m].u);
    EXPECT_EQ(pressed.markers[m].v, rest.markers[m].v);
  }
}

TEST(Give, WanderingSetsOutFromRest) {
  const std::string bend = "  - {use: bend, q1_mm: {from: -6, to: 6}, q2_mm: {from: -5, to: 5}}\n";
  const Plan plan = plan_of("motion: {kind: wander, frames_per_move: 4}\n" + scene_text(bend));
  EXPECT_EQ(plan.truth(0).pose.at("q1_mm"), 0.0);
  EXPECT_EQ(plan.truth(0).pose.at("q2_mm"), 0.0);
  EXPECT_NE(plan.truth(2).pose.at("q1_mm"), 0.0);
}

}  // namespace
}  // namespace alltact
