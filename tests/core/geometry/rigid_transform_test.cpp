#include "core/geometry/rigid_transform.h"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class Rigid : public testing::Test {
 protected:
  double uniform(double scale) { return std::uniform_real_distribution(-scale, scale)(random_); }
  Eigen::Vector3d point(double scale) { return {uniform(scale), uniform(scale), uniform(scale)}; }
  RigidTransform any() {
    return {rotation_from_rpy_deg({uniform(180), uniform(90), uniform(180)}), point(300)};
  }
  std::mt19937 random_{7};
};

TEST_F(Rigid, TurnsAboutXThenYThenZOfTheGripper) {
  // By hand: x by 90 degrees takes y to z, then y by 90 takes z to x, then z by 90 takes x to y.
  const auto turned = [](const Eigen::Vector3d& degrees, const Eigen::Vector3d& from) {
    return RigidTransform{rotation_from_rpy_deg(degrees), Eigen::Vector3d::Zero()}.point(from);
  };
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_LT((turned({90, 0, 0}, y) - z).norm(), 1e-15);
  EXPECT_LT((turned({0, 90, 0}, z) - x).norm(), 1e-15);
  EXPECT_LT((turned({0, 0, 90}, x) - y).norm(), 1e-15);
  EXPECT_LT((turned({90, 90, 0}, y) - x).norm(), 1e-15);
  EXPECT_LT((turned({90, 90, 90}, y) - y).norm(), 1e-15);
  EXPECT_LT((turned({30, 0, 0}, y) - Eigen::Vector3d(0, std::cos(30 * kDegree), 0.5)).norm(),
            1e-15);
}

TEST_F(Rigid, AnglesComeBackAlsoWhereTwoOfThemAreOne) {
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d degrees(uniform(180), uniform(89.9), uniform(180));
    EXPECT_LT((rpy_deg(rotation_from_rpy_deg(degrees)) - degrees).norm(), 1e-9);
  }
  for (const double upright : {90.0, -90.0}) {
    const auto rotation = rotation_from_rpy_deg({25, upright, 40});
    const Eigen::Vector3d degrees = rpy_deg(rotation);
    EXPECT_NEAR(degrees.y(), upright, 1e-6);
    EXPECT_EQ(degrees.z(), 0);
    EXPECT_LT(rotation_from_rpy_deg(degrees).angularDistance(rotation), 1e-7);
  }
}

TEST_F(Rigid, ItsInverseLeadsBack) {
  for (int i = 0; i < 300; ++i) {
    const RigidTransform there = any(), back = there.inverse();
    const Eigen::Vector3d p = point(500);
    EXPECT_LT((back.point(there.point(p)) - p).norm(), 1e-12 * 1000);
    EXPECT_LT((back.direction(there.direction(p)) - p).norm(), 1e-12 * 1000);
    EXPECT_LT((there.point(back.translation_mm)).norm(), 1e-12 * 1000) << "the gripper's middle";
  }
}

TEST_F(Rigid, KeepsDistancesAnglesAndHands) {
  for (int i = 0; i < 300; ++i) {
    const RigidTransform there = any();
    const Eigen::Vector3d p = point(200), q = point(200), r = point(200);
    EXPECT_NEAR((there.point(p) - there.point(q)).norm(), (p - q).norm(), 1e-11);
    EXPECT_NEAR(there.direction(p).dot(there.direction(q)), p.dot(q), 1e-9);
    const double volume = p.cross(q).dot(r);
    EXPECT_NEAR(there.direction(p).cross(there.direction(q)).dot(there.direction(r)), volume,
                1e-12 * 200 * 200 * 200);
  }
}

TEST_F(Rigid, ARotationWrittenWithFourDigitsCountsWithUnitLength) {
  const RigidTransform there{{0.7071, 0, 0.7071, 0}, {0, 0, 0}};
  const Eigen::Vector3d p(120, -30, 60);
  EXPECT_NEAR(there.point(p).norm(), p.norm(), 1e-12);
  EXPECT_LT((there.point(p) - Eigen::Vector3d(60, -30, -120)).norm(), 1e-12);
  EXPECT_LT((there.inverse().point(there.point(p)) - p).norm(), 1e-12);
}

}  // namespace
}  // namespace alltact
