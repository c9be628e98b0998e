#include "calibration/joint/calibrate.h"
#include "tests/support/made_press.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

const Layer kComparedLayer{0.7, 0.02};

/// A hard edge: the skin lies on the ball to the rim of its cap, where the circle looks for it.
std::vector<Press> presses_on(const MadeScene& scene, const Contact& contact) {
  std::mt19937 random(61);
  std::vector<Press> presses;
  for (int i = 0; i < 4; ++i)
    presses.push_back(make_press(scene, kComparedLayer, contact,
                                 {{130.0 + 40 * i, 110.0 + 25 * i, 4.0, 0.5 + 0.15 * i}}, 1.0,
                                 random, fmt::format("p{}", i))
                          .press);
  return presses;
}

std::vector<MethodRow> rows_of(const std::vector<Press>& presses, const MadeScene& scene) {
  const auto joint = calibrate(presses, scene.camera, scene.face, {}, Job{});
  EXPECT_TRUE(joint.ok());
  return compare_methods(presses, presses, scene.camera, scene.face, *joint, Job{});
}

const MethodRow& row_of(const std::vector<MethodRow>& rows, CalibrationMethod method) {
  for (const MethodRow& row : rows)
    if (row.method == method) return row;
  ADD_FAILURE() << method_name(method);
  return rows.front();
}

TEST(MethodTable, PutsEveryMethodBesideTheJointOne) {
  const MadeScene scene = flat_scene();
  const auto rows = rows_of(presses_on(scene, {}), scene);
  ASSERT_EQ(rows.size(), 4U);
  const MethodRow& joint = row_of(rows, CalibrationMethod::kJoint);
  EXPECT_EQ(joint.presses, 4);
  EXPECT_NEAR(joint.press_depth_mm, (0.5 + 0.65 + 0.8 + 0.95) / 4, 0.012);
  EXPECT_EQ(joint.at_depth_mm, joint.joint_depth_mm);
  // With skin as the circle takes it to be it comes near: brightness changes most some pixels
  // inside of where the skin leaves the ball.
  const MethodRow& circle = row_of(rows, CalibrationMethod::kCircle);
  EXPECT_EQ(circle.presses, 4);
  EXPECT_NEAR(circle.press_depth_mm, joint.press_depth_mm, 0.18);
  EXPECT_NEAR(circle.at_depth_mm, circle.joint_depth_mm, 0.25);
  EXPECT_GT(circle.residual_mm, joint.residual_mm);
  const MethodRow& paper = row_of(rows, CalibrationMethod::kPaper);
  EXPECT_EQ(paper.presses, 4);
  // Straight from above no ball hides its far side.
  EXPECT_THAT(row_of(rows, CalibrationMethod::kCone).failed.english(),
              testing::HasSubstr("0 degrees"));
}

TEST(MethodTable, TheCircleIsWrongWhereTheSkinLeavesTheBall) {
  const MadeScene scene = flat_scene();
  const auto rows = rows_of(presses_on(scene, {Skin::kHertz, 0, 0.02}), scene);
  const MethodRow& joint = row_of(rows, CalibrationMethod::kJoint);
  EXPECT_NEAR(joint.press_depth_mm, (0.5 + 0.65 + 0.8 + 0.95) / 4, 0.02);
  const MethodRow& circle = row_of(rows, CalibrationMethod::kCircle);
  ASSERT_EQ(circle.failed.english(), "");
  EXPECT_GT(std::abs(circle.press_depth_mm - joint.press_depth_mm), 0.1);
}

}  // namespace
}  // namespace alltact
