// Fingers that bend along a path of key frames. Other motions: plan_test.cpp,
// tip_deflection_test.cpp.
#include "core/simulation/scene_time.h"
#include "tests/core/simulation/scene_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

const std::string kBends = "  - {use: bend, q1_mm: {from: -5, to: 5}, q2_mm: {from: -4, to: 4}}\n";

Motion motion_of(const std::string& path) {
  YamlFile file("test.yaml", YamlFile::Unknown::kRefused);
  Motion motion;
  const Status read = file.read("frames: 90\nframes_per_s: 30\nmotion:\n  kind: path\n" + path,
                                [&](YamlSection& scene) {
                                  SceneTime::of(scene);
                                  YamlSection section = scene.section("motion");
                                  motion = Motion::read(section);
                                });
  EXPECT_TRUE(read) << read.error().sentence();
  return motion;
}

TEST(MotionAlongAPath, BendsAndThenHoldsStill) {
  const Motion motion =
      motion_of("  q1_mm: [{at: 0 s, is: -3}, {at: 1 s, is: 5, by: smooth}, {at: 2 s, is: 5}]\n");
  const DegreeOfFreedom q1{"q1_mm", -5, 5}, q2{"q2_mm", -4, 4};
  EXPECT_DOUBLE_EQ(motion.value(q1, 7, 0), -3);
  EXPECT_NEAR(motion.value(q1, 7, 15), 1, 1e-12) << "half-way";
  for (int frame = 30; frame < 90; ++frame) EXPECT_DOUBLE_EQ(motion.value(q1, 7, frame), 5);
  EXPECT_DOUBLE_EQ(motion.value(q1, 7, 90), -3) << "played without end it begins again";
  EXPECT_DOUBLE_EQ(motion.value(q2, 7, 45), 0) << "what is not named";
  EXPECT_DOUBLE_EQ(motion.value(q1, 8, 15), motion.value(q1, 7, 15)) << "nothing is drawn";
}

TEST(MotionAlongAPath, LeadsNowhereOutOfRange) {
  const auto refused = [](const std::string& motion) {
    return refusal("motion: {kind: path, " + motion + "}\n" + scene_text(kBends));
  };
  EXPECT_EQ(refused("q1_mm: [{at: 0, is: -5}, {at: 2, is: 5}]"), "");
  EXPECT_THAT(refused("q1_mm: [{at: 0, is: 0}, {at: 2, is: 5.5}]"),
              HasSubstr("q1_mm = 5.5 is outside the effect's range. Try: -5 to 5."));
  EXPECT_THAT(refused("q1_mm: [{at: 0, is: -6}, {at: 2, is: 5}]"), HasSubstr("q1_mm = -6 is"));
  EXPECT_THAT(refused("sway_mm: 1"),
              HasSubstr("the motion moves 'sway_mm', but the scene has no such effect"));
}

}  // namespace
}  // namespace alltact
