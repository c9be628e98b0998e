// The ghost of a finger moved further: held against what the definition of each motion says of the
// tip of a face that is known from drawing it.
#include "calibration/reference/motion_coverage.h"
#include "tests/support/made_press.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

using made::finger_scene;

/// A straight face: its middle line lies in the plane y = 0.
FaceShape straight_face() { return finger_scene(40.0, 20.0).shape; }

TEST(BendGhost, WithoutAMotionItIsTheOutlineThatIsSeen) {
  const FaceShape shape = straight_face();
  const auto outline = bent_outline(shape, {});
  ASSERT_TRUE(outline);
  ASSERT_EQ(outline->upper.size(), outline->lower.size());
  EXPECT_GT(outline->upper.size(), 20U);
  for (std::size_t i = 0; i < outline->upper.size(); ++i) {
    const auto u = static_cast<std::size_t>(std::lround(outline->upper[i].x()));
    EXPECT_NEAR(outline->upper[i].y(), shape.columns()[u].upper_v, 1.5);
    EXPECT_NEAR(outline->lower[i].y(), shape.columns()[u].lower_v, 1.5);
  }
}

TEST(BendGhost, TheTipGoesWhereTheMotionSaysAndTheBaseStays) {
  const FaceShape shape = straight_face();
  const auto rest = bent_outline(shape, {}).value();
  const auto middle = [](const BentOutline& outline, std::size_t i) {
    return Eigen::Vector2d(0.5 * (outline.upper[i] + outline.lower[i]));
  };
  const std::size_t tip = rest.upper.size() - 1;
  const bool is_base_left = shape.base_at_low_u();
  EXPECT_EQ(rest.upper[0].x() < rest.upper[tip].x(), is_base_left);
  // Sideways by 2 mm: by f * 2 / z in the picture.
  const auto swayed = bent_outline(shape, {0, 2, 0}).value();
  const auto at_tip = shape.at(middle(rest, tip).x(), middle(rest, tip).y()).value().view_point_mm;
  const double focal = shape.camera().parameters().fy_px;
  EXPECT_NEAR((middle(swayed, tip) - middle(rest, tip)).y(), 2 * focal / at_tip.z(), 0.3);
  EXPECT_NEAR((middle(swayed, 0) - middle(rest, 0)).norm(), 0, 0.1);
  // Half-way along a beam that is held at its base it is a quarter.
  const double half = (middle(swayed, tip / 2) - middle(rest, tip / 2)).y();
  EXPECT_GT(half, 0.2 * 2 * focal / 100);
  EXPECT_LT(half, 0.6 * (middle(swayed, tip) - middle(rest, tip)).y());
  // Away from the camera it is seen smaller, and towards it larger.
  const auto width = [&](const TipMotion& motion) {
    const auto outline = bent_outline(shape, motion).value();
    return (outline.lower.back() - outline.upper.back()).norm();
  };
  EXPECT_LT(width({4, 0, 0}), width({}));
  EXPECT_GT(width({-4, 0, 0}), width({}));
  // By 10 degrees from +v towards -u.
  const auto twisted = bent_outline(shape, {0, 0, 10}).value();
  const Eigen::Vector2d line = twisted.lower.back() - twisted.upper.back();
  EXPECT_NEAR(std::atan2(-line.x(), line.y()) * 180 / M_PI, 10, 0.7);
}

TEST(BendGhost, LeadsFromThePoseNowALittleBeyondWhatIsNeeded) {
  BendState image;
  image.need = {4, 2, 3};
  EXPECT_EQ(motion_left(image, BendDirection::kAway).bend_mm, 0) << "no pose is known";
  image.now = TipMotion{1, -0.5, 0.3};
  EXPECT_NEAR(motion_left(image, BendDirection::kAway).bend_mm, 4.4 - 1, 1e-12);
  EXPECT_NEAR(motion_left(image, BendDirection::kTowards).bend_mm, -4.4 - 1, 1e-12);
  EXPECT_NEAR(motion_left(image, BendDirection::kDown).sway_mm, 2.2 + 0.5, 1e-12);
  EXPECT_NEAR(motion_left(image, BendDirection::kUp).sway_mm, -2.2 + 0.5, 1e-12);
  EXPECT_NEAR(motion_left(image, BendDirection::kTwistRight).twist_deg, 3.3 - 0.3, 1e-12);
  EXPECT_NEAR(motion_left(image, BendDirection::kTwistLeft).twist_deg, -3.3 - 0.3, 1e-12);
}

}  // namespace
}  // namespace alltact
