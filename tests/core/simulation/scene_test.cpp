#include "core/simulation/scene.h"

#include "core/simulation/plan.h"
#include "tests/core/simulation/scene_text.h"

#include <filesystem>
#include <regex>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Scene, EveryShippedSceneCompilesAndSaysWhy) {
  int scenes = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(ALLTACT_SOURCE_DIR "/resources/scenes")) {
    SCOPED_TRACE(entry.path());
    const auto scene = Scene::load(entry.path());
    ASSERT_TRUE(scene) << scene.error().sentence();
    EXPECT_GT(scene->why.size(), 20U);
    const auto plan = Plan::compile(*scene, 1);
    ASSERT_TRUE(plan) << plan.error().sentence();
    ++scenes;
  }
  EXPECT_GE(scenes, 5);
}

TEST(Scene, UnknownThingsAreRefusedWithFileLineAndKey) {
  const std::string unknown_effect = refusal(scene_text("  - {use: sparkle}\n"));
  EXPECT_THAT(unknown_effect, HasSubstr("test.yaml:10"));
  EXPECT_THAT(unknown_effect, HasSubstr("'sparkle'"));
  EXPECT_THAT(unknown_effect, HasSubstr("quantisation"));  // names those that there are
  EXPECT_THAT(refusal(scene_text("  - {use: quantization}\n")),
              HasSubstr("Try: 'quantisation', or else one of"));

  const std::string unknown_key =
      refusal(scene_text("  - {use: quantisation}\n  - {use: read, sd: 1, amount: 2}\n"));
  EXPECT_THAT(unknown_key, HasSubstr("test.yaml:11: read.amount: unknown key 'amount'"));

  EXPECT_THAT(refusal(scene_text("  - {use: read, sd: 1, enabled: false}\n")),
              HasSubstr("unknown key 'enabled'"));
  EXPECT_THAT(refusal("colour: red\n" + scene_text("")), HasSubstr("unknown key 'colour'"));
}

TEST(Scene, WhatIsMisspeltIsRefusedWithTheNearestName) {
  const std::string rest = "  - {use: quantisation}\n";
  for (const auto& [wrong, meant] : {std::pair{"{use: roll_off, kind: hertz}", "'rolloff'"},
                                     {"{use: reed, sd: 1}", "'read'"},
                                     {"{use: read, sdd: 1}", "write 'sd' instead of 'sdd'"},
                                     {"{use: read, sd: 1, untill: 2}", "'until'"},
                                     {"{use: read, sd: 1, form: 2}", "'from'"},
                                     {"{use: drop, share: 0.1, rum: 2}", "'run'"}}) {
    const std::string problem = refusal(scene_text(rest + "  - " + wrong + "\n"));
    EXPECT_THAT(problem, HasSubstr("test.yaml:11: ")) << wrong;
    EXPECT_THAT(problem, HasSubstr(std::string(". Try: ") + meant)) << wrong;
  }
  EXPECT_THAT(refusal("frame_per_s: 25\n" + scene_text(rest)), HasSubstr("Try: 'frames_per_s'"));
}

TEST(Scene, StrengthZeroIsRefusedWithASentence) {
  for (const char* effect : {"  - {use: read, sd: 0}\n", "  - {use: shot, gain: 0.0}\n",
                             "  - {use: layer, scatter_per_mm: 0, along: z}\n"})
    EXPECT_THAT(refusal(scene_text(effect)), HasSubstr("leave out what is absent")) << effect;
}

TEST(Scene, EffectsThatCannotBeTogetherOrAloneAreRefused) {
  EXPECT_THAT(refusal(scene_text("  - {use: read, sd: 1}\n  - {use: read, sd: 2}\n")),
              HasSubstr("listed twice"));
  EXPECT_THAT(refusal(scene_text("  - {use: bulge, share: 0.1, width_mm: 1}\n")),
              HasSubstr("nothing is pressed in"));
  EXPECT_THAT(refusal(scene_text("  - {use: mjpeg, quality: 80}\n")), HasSubstr("quantisation"));
  EXPECT_THAT(
      refusal(scene_text("  - {use: ball, radius_mm: 4, s_mm: 30, y_mm: 0, depth_mm: 1.5}\n")),
      HasSubstr("reaches through the layer"));
  EXPECT_THAT(
      refusal(scene_text("  - {use: ball, radius_mm: 4, s_mm: 300, y_mm: 0, depth_mm: 1}\n")),
      HasSubstr("beyond the ends"));
  EXPECT_THAT(refusal("motion: {kind: random}\n" + scene_text("")), HasSubstr("nothing to move"));
  EXPECT_THAT(refusal("motion: {kind: hold, pose: {q1_mm: 2}}\n" + scene_text("")),
              HasSubstr("'q1_mm'"));
}

// Every number of a scene in turn becomes something that is no number.
TEST(Scene, SpoiledNumbersAreRefused) {
  const std::string text = scene_text(
      "  - {use: bend, q1_mm: {from: -5, to: 5}, q2_mm: {from: -4, to: 4}}\n"
      "  - {use: ball, radius_mm: 4, s_mm: 30, y_mm: 0, depth_mm: 1}\n"
      "  - {use: rolloff, kind: hertz, length_mm: 0.8}\n"
      "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
      "  - {use: shot, gain: 0.03}\n");
  ASSERT_EQ(refusal(text), "");
  const std::regex number(R"([ \[]-?[0-9.]+(?=[,}\]\n]))");
  int spoiled = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
    for (const char* wrong : {"pancake", ".nan", ".inf", "[[]]", "1e999", ""}) {
      std::string other = text;
      other.replace(static_cast<std::size_t>(it->position()) + 1,
                    static_cast<std::size_t>(it->length()) - 1, wrong);
      EXPECT_NE(refusal(other), "") << other;
      ++spoiled;
    }
  EXPECT_GT(spoiled, 100);
}

TEST(Scene, HostileTextsAreRefused) {
  const std::string text = scene_text("  - {use: shot, gain: 0.03}\n");
  ASSERT_EQ(refusal(text), "");
  EXPECT_THAT(refusal(text + "name: again\n"), HasSubstr("given twice"));
  EXPECT_THAT(refusal(text + "---\n" + text), HasSubstr("more than one document"));
  EXPECT_THAT(refusal(text + "self: &x [*x]\n"), HasSubstr("unknown key 'self'"));
  EXPECT_THAT(refusal(text + std::string(5000, '[')), HasSubstr("not YAML"));
  EXPECT_NE(refusal(text + std::string(1, '\0') + "\n"), "");
  std::string many = "  - {use: shot, gain: 0.03}\n  - {use: leds, lamps: [&lamp {a: 1";
  for (int i = 0; i < 2000; ++i) many += fmt::format(", a{}: 1", i);
  many += "}";
  for (int i = 0; i < 2000; ++i) many += ", *lamp";
  EXPECT_THAT(refusal(scene_text(many + "]}\n")), HasSubstr("too large to be read"));
}

TEST(Scene, NoTruncationOfASceneCrashes) {
  const std::string text = scene_text("  - {use: shot, gain: 0.03}\n");
  for (std::size_t n = 0; n + 30 < text.size(); ++n) EXPECT_NE(refusal(text.substr(0, n)), "") << n;
}

}  // namespace
}  // namespace alltact
