// Scenes on other fingers than the one they were written for.
#include "calibration/experiments/experiment_bench.h"
#include "core/base/atomic_file.h"
#include "core/simulation/plan.h"

#include <string>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

std::filesystem::path scene_named(const std::string& name) {
  return std::filesystem::path(ALLTACT_SOURCE_DIR "/resources/scenes") / (name + ".yaml");
}

Plan plan_on(const std::string& name, const FingerVariant& finger) {
  const auto file = scene_named(name);
  const auto scene = scene_on_finger(read_file(file).value(), file, finger);
  EXPECT_TRUE(scene) << scene.error().sentence();
  auto plan = Plan::compile(*scene, 1);
  EXPECT_TRUE(plan) << plan.error().sentence();
  return std::move(plan).value();
}

bool same(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0;
}

// With the values of the file put in their own places nothing is another picture, a body's file
// beside the scene and a list of numbers included.
TEST(FingerVariant, TheDemonstrationsFingerLeavesASceneAsItIs) {
  for (const std::string name : {"experiment_pose", "experiment_force", "experiment_references"}) {
    const auto written = Plan::compile(Scene::load(scene_named(name)).value(), 1);
    ASSERT_TRUE(written);
    const Plan again = plan_on(name, {});
    EXPECT_EQ(again.frame_count(), written->frame_count());
    EXPECT_TRUE(same(again.render(2, 2), written->render(2, 2))) << name;
  }
}

TEST(FingerVariant, IsWhatASceneShowsFromThenOn) {
  FingerVariant drawn = FingerVariant::draw(7, 3);
  drawn.scale = 0.5;
  const Plan plan = plan_on("experiment_localisation", drawn);
  const Finger& finger = plan.finger();
  EXPECT_EQ(finger.camera.width_px, 480);
  EXPECT_EQ(finger.camera.height_px, 270);
  EXPECT_DOUBLE_EQ(finger.camera.fx_px, drawn.focal_px / 2);
  // The same ray through the middle: pixel centres lie at whole numbers.
  EXPECT_DOUBLE_EQ(2 * (finger.camera.cx_px + 0.5), drawn.cx_px + 0.5);
  EXPECT_DOUBLE_EQ(finger.face.width_mm, drawn.width_mm);
  EXPECT_DOUBLE_EQ(finger.face.layer_mm, drawn.layer_mm);
  EXPECT_EQ(finger.markers.per_row, drawn.per_row);
  EXPECT_EQ(plan.truth(0).markers.size(), 2U * static_cast<unsigned>(drawn.per_row));
}

TEST(FingerVariant, IsTheSameForTheSameSeedAndNumberAndAnotherForOthers) {
  const FingerVariant one = FingerVariant::draw(7, 3);
  EXPECT_EQ(one.length_mm, FingerVariant::draw(7, 3).length_mm);
  EXPECT_NE(one.length_mm, FingerVariant::draw(7, 4).length_mm);
  EXPECT_NE(one.length_mm, FingerVariant::draw(8, 3).length_mm);
  EXPECT_NE(one.shore_a, FingerVariant::draw(7, 4).shore_a);
}

TEST(FingerVariant, ARoomLightsScenesThatNameItAndNoOthers) {
  FingerVariant lit;
  lit.room_level = 10;
  const auto mean = [](const Plan& plan) { return cv::mean(plan.render(0, 2))[0]; };
  const double dark = mean(plan_on("experiment_room_light", {}));
  const double bright = mean(plan_on("experiment_room_light", lit));
  EXPECT_GT(bright, dark + 0.5);
  EXPECT_LT(bright, dark + 10);
  EXPECT_TRUE(
      same(plan_on("experiment_pose", lit).render(0), plan_on("experiment_pose", {}).render(0)));
}

TEST(FingerVariant, WhatIsWrongWithASceneIsTold) {
  const auto refused = scene_on_finger("name: x\neffects: [", "wrong.yaml", {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("wrong.yaml"), std::string::npos);
}

}  // namespace
}  // namespace alltact
