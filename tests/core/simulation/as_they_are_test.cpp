// What is simple is computed as simple: a straight face, a ball without roll-off, a lamp's lobe.
#include "core/simulation/face_curve.h"
#include "core/simulation/press.h"
#include "tests/core/simulation/scene_text.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using Real = long double;
constexpr Real kIncline = 34 * std::numbers::pi_v<Real> / 180;

TEST(FaceCurve, WithoutBendingIsTheStraightLine) {
  FaceCurve curve({-25, 0.5, 28}, static_cast<double>(kIncline), 116);
  curve.integrate();
  ASSERT_TRUE(curve.is_straight());
  for (const double s : {-3.0, 0.0, 0.1, 57.3, 116.0, 130.0}) {
    const FaceCurve::Node p = curve.at(s);
    EXPECT_NEAR(p.x_mm, -25 + s * std::cos(kIncline), 2e-14);
    EXPECT_NEAR(p.z_mm, 28 + s * std::sin(kIncline), 2e-14);
    EXPECT_EQ(p.theta, static_cast<double>(kIncline));
    EXPECT_EQ(p.theta_s, 0.0);
    EXPECT_EQ(p.shift_mm, 0.5);
    const Real direction = p.x_mm / Real{p.z_mm};
    EXPECT_NEAR(curve.intersect(0, static_cast<double>(direction)), s, 1e-12);
  }
  EXPECT_TRUE(std::isnan(curve.intersect(0, 1.5)));     // steeper than the face
  EXPECT_TRUE(std::isnan(curve.intersect(-200, 0.0)));  // behind the camera
}

TEST(FaceCurve, SwayShiftsAStraightFaceAndLeavesItStraight) {
  FaceCurve curve({-25, 0, 28}, static_cast<double>(kIncline), 116);
  curve.sway(2);
  curve.integrate();
  ASSERT_TRUE(curve.is_straight());
  for (const double s : {0.0, 20.3, 58.0, 115.9}) {
    EXPECT_NEAR(curve.at(s).shift_mm, 2 * s * s / (116 * 116), 1e-14);
    EXPECT_NEAR(curve.at(s).z_mm, 28 + s * std::sin(kIncline), 2e-14);
  }
  EXPECT_NEAR(curve.at(126).shift_mm, 2 + 10 * 4.0 / 116, 1e-13);
  // Bent afterwards, it is a curve that starts from there.
  curve.bend(3, 0);
  curve.integrate();
  EXPECT_FALSE(curve.is_straight());
  EXPECT_NEAR(curve.at(116).shift_mm, 2, 1e-13);
  EXPECT_NEAR(curve.at(116).theta, static_cast<double>(kIncline + 6.0L / 116), 1e-14);
}

TEST(FaceCurve, BentByNothingTheCurveIsTheLine) {
  FaceCurve line({-25, 0, 28}, static_cast<double>(kIncline), 116), curve = line;
  curve.bend(0, 0);
  curve.integrate();
  EXPECT_FALSE(curve.is_straight());
  for (double s = -5; s < 125; s += 0.7) {
    EXPECT_NEAR(curve.at(s).x_mm, line.at(s).x_mm, 1e-12);
    EXPECT_NEAR(curve.at(s).z_mm, line.at(s).z_mm, 1e-12);
  }
  for (double direction = -0.85; direction < 1.2; direction += 0.01)
    EXPECT_NEAR(curve.intersect(0, direction), line.intersect(0, direction), 1e-11);
}

TEST(BallPress, HasNoProfileUnlessSomethingGivesItOne) {
  PressPose pose;
  pose.depth_mm = 0.8;
  pose.luf_mm = {0, 0, 30};
  pose.normal = Eigen::Vector3d::UnitZ();
  pose.along = Eigen::Vector3d::UnitX();
  const BallPress press = make_ball_press(pose, 4);
  EXPECT_TRUE(press.profile_mm.empty());
  EXPECT_GE(press.reach_mm(), press.rim_mm);
}

// cos^lobe: the light of a lobe over that without is the same power of what lobe 1 makes of it.
TEST(Leds, EveryLobeIsItsPowerOfTheCosine) {
  const auto image = [](const std::string& aim) {
    return plan_of(
               scene_text(fmt::format(
                   "  - {{use: leds, lamps: [{{at_mm: [4, 0, -20], power: 2000000{}}}]}}\n", aim)))
        .render(0);
  };
  const cv::Mat plain = image("");
  for (const int lobe : {1, 2, 4, 8}) {
    const cv::Mat aimed = image(fmt::format(", aim_mm: [71, 0, 93], lobe: {}", lobe));
    const Eigen::Vector3d lamp(4, 0, -20), aim = (Eigen::Vector3d(71, 0, 93) - lamp).normalized();
    int compared = 0;
    for (int u = 20; u < 240; u += 3)
      for (int v = 60; v < 120; v += 3) {
        // The straight face, where the pixel's ray meets it.
        const double t = (u - 158.5) / 170, w = (v - 90.25) / 172;
        const double c = std::cos(static_cast<double>(kIncline));
        const double sin = std::sin(static_cast<double>(kIncline));
        const double z = (28 * c + 25 * sin) / (c - t * sin);
        const Eigen::Vector3d p(t * z, w * z, z);
        if (std::abs(p.y()) > 11.5 || plain.at<float>(v, u) <= 0) continue;
        const double expected = std::pow(aim.dot((p - lamp).normalized()), lobe);
        EXPECT_NEAR(aimed.at<float>(v, u) / double{plain.at<float>(v, u)}, expected, 3e-6);
        ++compared;
      }
    EXPECT_GT(compared, 500);
  }
}

}  // namespace
}  // namespace alltact
