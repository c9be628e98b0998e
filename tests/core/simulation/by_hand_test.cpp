// A scene of two effects against the same picture written by hand.
#include "tests/core/simulation/scene_text.h"
#include "tests/support/two_effects_by_hand.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(TwoEffects, AreTheSameBytesAsAHandWrittenLoop) {
  const auto scene = Scene::load(ALLTACT_SOURCE_DIR "/resources/scenes/two_effects.yaml");
  ASSERT_TRUE(scene) << scene.error().sentence();
  const Plan plan = Plan::compile(*scene, 1).value();
  const auto camera = Camera::create(plan.finger().camera);
  ASSERT_TRUE(camera);
  const cv::Mat by_hand = two_effects_by_hand(PixelRays(*camera), plan.finger().face);
  const cv::Mat picture = plan.render(0);
  EXPECT_GT(cv::countNonZero(picture), 500000);
  EXPECT_TRUE(same_bytes(by_hand, picture));
  EXPECT_TRUE(same_bytes(by_hand, plan.render(0, 3)));
}

}  // namespace
}  // namespace alltact
