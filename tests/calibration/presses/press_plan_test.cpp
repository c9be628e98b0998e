// Where to press next, on a face whose points are known from drawing it.
#include "calibration/presses/guided_presses.h"
#include "core/geometry/ball.h"
#include "tests/support/made_press.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

FaceShape drawn_face() { return finger_scene(40.0, 20.0).shape; }

TEST(PressPlan, SixPlacesInAllThirdsOnBothSidesAtThreeDepthsAllOnTheFace) {
  const FaceShape shape = drawn_face();
  const auto targets = first_presses(shape);
  ASSERT_EQ(targets.size(), 6U);
  std::array<int, 3> thirds{};
  double length = 0;
  for (int u = 0; u < shape.width_px(); ++u)
    if (shape.columns()[static_cast<std::size_t>(u)].valid)
      length = std::max(length, shape.length_at(u));
  int sides = 0;
  for (const PressTarget& target : targets) {
    ++thirds.at(static_cast<std::size_t>(std::min(2.0, 3 * target.position_mm.x() / length)));
    sides += target.position_mm.y() > 0 ? 1 : -1;
    EXPECT_GE(target.depth_mm, 0.4 * shape.face().layer_mm);
    EXPECT_LE(target.depth_mm, 0.7 * shape.face().layer_mm);
    EXPECT_LT(std::abs(target.position_mm.y()), 0.25 * shape.face().width_mm);
  }
  EXPECT_EQ(thirds, (std::array{2, 2, 2}));
  EXPECT_EQ(sides, 0);
}

TEST(PressPlan, ThePixelOfAPlaceShowsThatPlace) {
  const FaceShape shape = drawn_face();
  for (const PressTarget& target : first_presses(shape)) {
    const auto pixel = pixel_of_position(shape, target.position_mm);
    ASSERT_TRUE(pixel);
    const Eigen::Vector2d back = shape.position_mm(pixel->x(), pixel->y());
    EXPECT_NEAR(back.x(), target.position_mm.x(), 0.05);
    EXPECT_NEAR(back.y(), target.position_mm.y(), 0.05);
  }
  // Beyond the face it is the nearest place that is seen.
  const auto far = pixel_of_position(shape, {1e4, 1e4});
  ASSERT_TRUE(far);
  EXPECT_LE(far->x(), shape.width_px());
}

TEST(PressPlan, TheNextOneIsTheFirstThatNoPressStandsFor) {
  const std::vector<PressTarget> targets{{{10, 3}, 0.6}, {{30, -3}, 0.8}, {{50, 3}, 1.0}};
  EXPECT_EQ(next_press(targets, {})->position_mm, Eigen::Vector2d(10, 3));
  EXPECT_EQ(next_press(targets, {{12, 1}})->position_mm, Eigen::Vector2d(30, -3));
  EXPECT_EQ(next_press(targets, {{12, 1}, {9, 2}})->position_mm, Eigen::Vector2d(30, -3))
      << "two at one place stand for one";
  EXPECT_EQ(next_press(targets, {{48, 0}, {11, 0}})->position_mm, Eigen::Vector2d(30, -3));
  EXPECT_FALSE(next_press(targets, {{48, 0}, {11, 0}, {28, -2}}));
  EXPECT_FALSE(next_press({}, {{1, 1}}));
}

TEST(PressPlan, SaysDeeperEnoughAndTooDeep) {
  EXPECT_EQ(press_progress(0.5, 0.8, 1.5), PressProgress::kDeeper);
  EXPECT_EQ(press_progress(0.7, 0.8, 1.5), PressProgress::kEnough);
  EXPECT_EQ(press_progress(0.8, 0.8, 1.5), PressProgress::kEnough);
  EXPECT_EQ(press_progress(1.15, 0.8, 1.5), PressProgress::kTooDeep);
  EXPECT_EQ(press_progress(1.25, 1.2, 1.5), PressProgress::kTooDeep) << "eight tenths of the layer";
}

TEST(DiscDepth, IsThatOfACapWhereItsDepthHasFallenToTheLevel) {
  // Exactly: depth(r) = h - (R - sqrt(R^2 - r^2)) = level h.
  for (const double radius : {3.0, 4.0, 8.0})
    for (const double depth : {0.2, 0.5, 1.0}) {
      const double below = radius - (1 - kDiscLevel) * depth;
      const double disc = std::sqrt(radius * radius - below * below);
      EXPECT_NEAR(disc_depth_mm(disc, radius), depth, 0.3 * depth * depth / radius + 1e-12);
    }
  EXPECT_DOUBLE_EQ(disc_depth_mm(100, 4), 3.6) << "never deeper than nearly the ball's radius";
}

}  // namespace
}  // namespace alltact
