// The scenes whose cost is measured: what they hold, and the same picture written by hand.
#include "core/simulation/effect.h"
#include "tests/core/simulation/scene_text.h"
#include "tests/support/two_effects_by_hand.h"

#include <gmock/gmock.h>
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
  const cv::Mat image = plan.render(0);
  EXPECT_GT(cv::countNonZero(image), 500000);
  EXPECT_TRUE(same_bytes(by_hand, image));
  EXPECT_TRUE(same_bytes(by_hand, plan.render(0, 3)));
}

TEST(SensorEffects, AreAllInTheSceneThatIsMeasured) {
  const auto scene = Scene::load(ALLTACT_SOURCE_DIR "/tests/bench/sensor_effects.yaml");
  ASSERT_TRUE(scene) << scene.error().sentence();
  const Plan plan = Plan::compile(*scene, 1).value();
  for (const EffectKind* kind : effect_kinds())
    if (kind->stage == Stage::kSensor) {
      EXPECT_THAT(plan.effects(), testing::Contains(kind->name));
    }
  const cv::Mat image = plan.render(7);
  for (const int threads : {2, 3}) EXPECT_TRUE(same_bytes(plan.render(7, threads), image));
}

}  // namespace
}  // namespace alltact
