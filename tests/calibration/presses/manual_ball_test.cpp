// A ball that somebody put by hand: where the fit begins, never where it ends.
#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "core/geometry/ball.h"
#include "tests/support/made_press.h"

#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alltact {
namespace {

using namespace made;
using testing::HasSubstr;

struct Presses {
  MadeScene scene = finger_scene(40.0, 20.0);
  std::vector<Press> presses;
  std::vector<Eigen::Vector3d> centres_mm;
};

Presses five_presses() {
  Presses made;
  std::mt19937 random(31);
  for (int i = 0; i < 5; ++i) {
    const Ball ball{330.0 + 60 * i, 215.0 + 25 * i, 4.0, 0.5 + 0.15 * i};
    Made one = make_press(made.scene, {}, {Skin::kHertz, 0, 0.02}, {ball}, 1.0, random,
                          fmt::format("p{}", i));
    made.presses.push_back(std::move(one.press));
    made.centres_mm.push_back(one.centre_mm);
  }
  return made;
}

Calibration solve(const Presses& made) {
  auto result = calibrate(made.presses, made.scene.camera, made.scene.face, {}, Job());
  EXPECT_TRUE(result.ok()) << result.error().sentence();
  return std::move(result).value();
}

TEST(PlacedBall, AHandThatIsNearComesToTheSameSolutionAsTheProgram) {
  Presses made = five_presses();
  const Calibration found = solve(made);
  // Off by as much as a careless hand: four to six pixels sideways, half a millimetre in depth.
  for (std::size_t i = 0; i < made.presses.size(); ++i)
    made.presses[i].ball_mm =
        made.centres_mm[i] + Eigen::Vector3d(i % 2 ? 0.4 : -0.4, 0.3, i % 2 ? 0.1 : -0.3);
  const Calibration placed = solve(made);
  ASSERT_EQ(placed.balls.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_LT((placed.balls[i].centre_mm - found.balls[i].centre_mm).norm(), 0.035) << i;
  EXPECT_NEAR(placed.residual_mm, found.residual_mm, 0.002);
}

TEST(PlacedBall, ServesAPressInWhichNoBallIsFound) {
  Presses made = five_presses();
  std::mt19937 random(32);
  // A second contact, as large: which of the two is the ball only a person can say.
  const Ball ball{420.0, 240.0, 4.0, 0.8}, thumb{640.0, 300.0, 4.0, 0.8};
  Made two = make_press(made.scene, {}, {}, {ball, thumb}, 1.0, random, "two");
  made.presses.push_back(two.press);
  EXPECT_THAT(solve(made).left_out, testing::ElementsAre(testing::Property(
                                        &Message::english, HasSubstr("two contacts"))));
  made.presses.back().ball_mm = two.centre_mm + Eigen::Vector3d(0.2, 0.1, 0.1);
  const Calibration calibration = solve(made);
  EXPECT_TRUE(calibration.left_out.empty());
  ASSERT_EQ(calibration.balls.size(), 6U);
  EXPECT_LT((calibration.balls.back().centre_mm - two.centre_mm).norm(), 0.1);
}

TEST(PlacedBall, ABallThatDoesNotTouchIsLeftOutWithTheReason) {
  Presses made = five_presses();
  made.presses[1].ball_mm = made.centres_mm[1] + Eigen::Vector3d(0, 0, 3);
  const Calibration calibration = solve(made);
  EXPECT_EQ(calibration.balls.size(), 4U);
  ASSERT_EQ(calibration.left_out.size(), 1U);
  EXPECT_THAT(calibration.left_out[0].english(), HasSubstr("p1: the ball that was set by hand"));
}

TEST(PlacedBall, LiesOnTheFaceAsItWasPressedIn) {
  const Presses made = five_presses();
  for (std::size_t i = 0; i < 5; ++i) {
    const auto contact =
        ball_on_face(made.presses[i].shape, made.scene.face, made.centres_mm[i], 4.0);
    ASSERT_TRUE(contact);
    EXPECT_NEAR(contact->depth_mm, 0.5 + 0.15 * static_cast<double>(i), 0.005);
    EXPECT_NEAR((contact->normal - made.scene.normal).norm(), 0, 1e-3);
    // Every point of the rim lies on the ball and in the untouched face.
    for (const auto& pixel : contact_rim_px(made.scene.camera, *contact, 24)) {
      const Eigen::Vector3d sight = made.scene.camera.unproject(pixel)->direction;
      const double z = contact->middle_mm.dot(contact->normal) / sight.dot(contact->normal);
      EXPECT_NEAR((z * sight - made.centres_mm[i]).norm(), 4.0, 1e-6);
    }
  }
}

}  // namespace
}  // namespace alltact
