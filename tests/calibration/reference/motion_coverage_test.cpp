#include "calibration/reference/motion_coverage.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(MotionCoverage, NothingSeenMissesEveryDirection) {
  const MotionCoverage coverage{MotionNeed{}};
  EXPECT_EQ(coverage.covered(), 0.0);
  EXPECT_EQ(coverage.missing().size(), 6U);
}

TEST(MotionCoverage, NamesTheDirectionThatIsMissing) {
  MotionCoverage coverage{MotionNeed{4.0, 1.5, 2.0}};
  for (double t = 0; t < 200; t += 0.02) {
    // All but bending far towards the camera.
    const double bend = 4.0 * std::sin(1.7 * t);
    coverage.add({std::max(bend, -1.0), 1.6 * std::sin(2.3 * t), 2.2 * std::sin(3.1 * t)});
  }
  const auto missing = coverage.missing();
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_THAT(missing.front().english(), testing::HasSubstr("towards the camera: 1.0 of 4.0 mm"));
}

TEST(MotionCoverage, CombinationsCountAsWell) {
  MotionCoverage apart{MotionNeed{4.0, 1.5, 2.0}}, together = apart;
  for (double t = 0; t < 400; t += 0.02) {
    const double bend = 4.0 * std::sin(1.7 * t), sway = 1.5 * std::sin(2.3 * t),
                 twist = 2.2 * std::sin(3.1 * t);
    apart.add({bend, 0.0, twist});
    apart.add({0.0, sway, twist});
    together.add({bend, sway, twist});
  }
  ASSERT_EQ(apart.missing().size(), 1U);
  EXPECT_THAT(apart.missing().front().english(),
              testing::HasSubstr("while its tip is pushed aside"));
  EXPECT_TRUE(together.missing().empty());
  EXPECT_GT(together.covered(), 0.95);
}

TEST(MotionCoverage, MotionIsThatOfThePairOfDots) {
  const TipPose rest{{30.0, 0.0, 80.0}, Eigen::Vector3d(-0.6, 0.0, 0.8), 0.1};
  TipPose now = rest;
  now.middle_mm += 2.0 * rest.normal + Eigen::Vector3d(0.0, -1.5, 0.0);
  now.turn_rad += 3.0 * M_PI / 180.0;
  const TipMotion motion = motion_between(rest, now);
  EXPECT_NEAR(motion.bend_mm, 2.0, 1e-12);
  EXPECT_NEAR(motion.sway_mm, -1.5, 1e-12);
  EXPECT_NEAR(motion.twist_deg, 3.0, 1e-12);
}

}  // namespace
}  // namespace alltact
