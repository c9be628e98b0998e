// Effects that are there for a part of a scene only.
#include "core/simulation/effect.h"
#include "tests/core/simulation/scene_text.h"
#include "tests/support/slow_run.h"

#include <filesystem>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kPlain =
    "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n"
    "  - {use: sides, albedo: 0.1, depth_mm: 14}\n"
    "  - {use: leds, lamps: [{at_mm: [0, 3, 0], power: 500000}]}\n"
    "  - {use: markers, radius_mm: 1.5, setback_mm: 4, first: 0.1, last: 0.9, albedo: 0.9}\n"
    "  - {use: read, sd: 1}\n";

/// Effects that draw, shape, press and change the sensor; {} stands for their presence.
std::string guests(const std::string& presence) {
  std::string text;
  for (const char* guest :
       {"use: bend, q1_mm: {from: -5, to: 5}, q2_mm: {from: -4, to: 4}",
        "use: sway, sway_mm: {from: -2, to: 2}",
        "use: ball, radius_mm: 4, s_mm: {from: 20, to: 60}, y_mm: 2, depth_mm: 1, give_mm: 2",
        "use: rolloff, kind: hertz, length_mm: 0.8", "use: bulge, share: 0.03, width_mm: 1.5",
        "use: occlusion, count: 3", "use: shot, gain: 0.03", "use: quantisation",
        "use: mjpeg, quality: 80"})
    text += fmt::format("  - {{{}{}}}\n", guest, presence);
  return text;
}

std::string in_frames(std::string text, int frames) {
  return text.replace(text.find("frames: 3"), 9, fmt::format("frames: {}", frames));
}

TEST(Presence, OutsideItAFrameIsAsIfTheEffectsWereNotNamed) {
  const std::string moving = "motion: {kind: random}\n";
  for (const std::uint64_t seed : {1, 7, 123456789}) {
    const Plan partly =
        plan_of(moving + in_frames(scene_text(guests(", from: 2, until: 4") + kPlain), 6), seed);
    const Plan without = plan_of(in_frames(scene_text(kPlain), 6), seed);
    const Plan always = plan_of(moving + in_frames(scene_text(guests("") + kPlain), 6), seed);
    for (int frame = 0; frame < 6; ++frame) {
      const Plan& like = frame >= 2 && frame < 4 ? always : without;
      EXPECT_EQ(partly.effects(frame), like.effects(frame)) << frame;
      for (const int threads : {1, 2, 5})
        EXPECT_TRUE(same_bytes(partly.render(frame, threads), like.render(frame))) << frame;
      EXPECT_EQ(partly.truth(frame).to_json(), like.truth(frame).to_json()) << frame;
      EXPECT_TRUE(same_bytes(partly.truth(frame).depth_mm, like.truth(frame).depth_mm)) << frame;
    }
    EXPECT_FALSE(same_bytes(always.render(1), without.render(1)));
  }
}

TEST(Presence, IsSaidInFramesOrSecondsAndHandsOverWithoutGapOrOverlap) {
  const auto effects_at = [](const std::string& presence, int frames, double per_s) {
    const Plan plan =
        plan_of(fmt::format("frames_per_s: {}\n", per_s) +
                in_frames(scene_text("  - {use: read, sd: 1" + presence + "}\n"), frames));
    std::string there;
    for (int frame = 0; frame < frames; ++frame) there += plan.effects(frame).empty() ? '.' : 'r';
    return there;
  };
  EXPECT_EQ(effects_at("", 4, 30), "rrrr");
  EXPECT_EQ(effects_at(", from: 1", 4, 30), ".rrr");
  EXPECT_EQ(effects_at(", until: 3", 4, 30), "rrr.");
  EXPECT_EQ(effects_at(", from: 1, until: 3", 4, 30), ".rr.");
  EXPECT_EQ(effects_at(", from: 0.5 s, until: 1.5s", 8, 4), "..rrrr..");
  // Between frames: with the first frame after it. 0.3 s at 30 a second is frame 9, exactly.
  EXPECT_EQ(effects_at(", from: 0.3 s", 11, 30), ".........rr");
  EXPECT_EQ(effects_at(", from: 0.31 s", 11, 30), "..........r");
  EXPECT_EQ(effects_at(", until: 0.3 s", 11, 30), "rrrrrrrrr..");
  EXPECT_EQ(effects_at(", until: 9 s", 3, 30), "rrr");
  const Plan both =
      plan_of(scene_text("  - {use: read, sd: 1, until: 1}\n  - {use: read, sd: 2, from: 1}\n"));
  EXPECT_THAT(both.effects(0), ElementsAre("read"));
  EXPECT_THAT(both.effects(1), ElementsAre("read#2"));
  EXPECT_THAT(both.effects(), ElementsAre("read", "read#2"));
}

TEST(Presence, ASceneThatGoesOnStartsItsEffectsAgain) {
  const Plan plan = plan_of(scene_text(guests(", from: 1, until: 2") + kPlain));
  for (int frame = 0; frame < 9; ++frame)
    EXPECT_EQ(plan.effects(frame), plan.effects(frame % 3)) << frame;
  EXPECT_NE(plan.effects(0), plan.effects(1));
  // Draws go on: a frame of the second round is no copy.
  EXPECT_FALSE(same_bytes(plan.render(0), plan.render(3)));
}

TEST(Presence, WrongTimesAreRefusedWithFileLineAndKey) {
  const auto problem = [](const std::string& presence) {
    return refusal(scene_text("  - {use: quantisation}\n  - {use: read, sd: 1" + presence + "}\n"));
  };
  EXPECT_THAT(problem(", from: 3"), HasSubstr("test.yaml:11: read.from: the scene ends"));
  EXPECT_THAT(problem(", from: 0.1 s"), HasSubstr("one of its frames, 0 to 2"));
  EXPECT_THAT(problem(", from: 1, until: 1"),
              HasSubstr("test.yaml:11: read.until: it would never"));
  EXPECT_THAT(problem(", until: 0"), HasSubstr("leave the effect out"));
  for (const char* wrong :
       {"soon", "-1", "1 min", ".nan", ".inf", "1e999", "[1]", "[[]]", "1 2", "s", "''", "{a: 1}"})
    for (const char* key : {"from", "until"})
      EXPECT_THAT(problem(fmt::format(", {}: {}", key, wrong)),
                  HasSubstr(fmt::format("test.yaml:11: read.{}: must be", key)))
          << wrong;
  EXPECT_THAT(problem(", form: 1"), HasSubstr("unknown key 'form'. Try: 'from'"));
}

TEST(Presence, WhatCannotBeAloneIsRefusedForTheFramesInWhichItWouldBe) {
  const std::string ball =
      "  - {use: ball, radius_mm: 4, s_mm: 30, y_mm: 0, depth_mm: 1, from: 1}\n";
  EXPECT_EQ(refusal(scene_text(ball + "  - {use: rolloff, kind: hertz, from: 1}\n")), "");
  EXPECT_THAT(refusal(scene_text(ball + "  - {use: rolloff, kind: hertz}\n")),
              HasSubstr("rolloff: nothing is pressed in, so nothing rolls off, in frames 0 to 0"));
  EXPECT_THAT(
      refusal(scene_text("  - {use: quantisation, until: 2}\n  - {use: mjpeg, quality: 80}\n")),
      HasSubstr("in frames 2 to 2"));
  EXPECT_THAT(
      refusal(scene_text("  - {use: read, sd: 1, until: 2}\n"
                         "  - {use: read, sd: 2, from: 1}\n")),
      HasSubstr("test.yaml:11: read#2.use: the effect 'read' is listed twice for frames 1 to 1"));
  const Plan partly = plan_of(scene_text("  - {use: quantisation, from: 1}\n"));
  EXPECT_THAT(partly.check_grey_levels("x").error().sentence(), HasSubstr("in frames 0 to 0"));
}

/// What each frame of a scene file holds, read here without the simulation.
struct Listed {
  int frames = 1;
  std::vector<std::map<std::string, int>> present;  // effects by name, for each frame
  std::size_t named = 0;
};

Listed listed(const std::filesystem::path& path) {
  Listed listed;
  YamlFile file(path);
  const Status read = file.load([&](YamlSection& top) {
    listed.frames = top.integer_or("frames", 1, 1, 1000000);
    const double per_s = top.number_or("frames_per_s", 30, {0, 1e9});
    listed.present.resize(static_cast<std::size_t>(listed.frames));
    for (YamlSection& effect : top.sections("effects")) {
      ++listed.named;
      const auto time = [&](const char* key, double otherwise) {
        if (!effect.has(key)) return otherwise;
        const std::string text = effect.text(key);
        return std::stod(text) * (text.ends_with("s") ? per_s : 1);
      };
      const double from = time("from", 0), until = time("until", listed.frames);
      for (int frame = 0; frame < listed.frames; ++frame)
        if (frame >= from - 1e-6 && frame < until - 1e-6)
          ++listed.present[static_cast<std::size_t>(frame)][effect.text("use")];
    }
  });
  EXPECT_TRUE(read) << read.error().sentence();
  return listed;
}

/// The first and the last frame of every stretch in which the same is there; in a slow run all.
std::vector<int> frames_to_build(const Listed& scene) {
  std::vector<int> frames;
  for (int frame = 0; frame < scene.frames; ++frame) {
    const auto at = static_cast<std::size_t>(frame);
    const bool begins = frame == 0 || scene.present[at] != scene.present[at - 1];
    const bool ends = frame + 1 == scene.frames || scene.present[at] != scene.present[at + 1];
    if (begins || ends || test::is_slow_run()) frames.push_back(frame);
  }
  return frames;
}

TEST(Presence, EveryFrameOfEveryShippedSceneBuildsWhatIsPresentAndNothingElse) {
  std::map<std::string, Stage> stages;
  for (const EffectKind* kind : effect_kinds()) stages[kind->name] = kind->stage;
  const std::array kWholePicture{"automatic-exposure", "defocus", "motion-blur", "rolling-shutter",
                                 "veil"};
  const BuildCount& count = build_count();
  int partly = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(ALLTACT_SOURCE_DIR "/resources/scenes")) {
    SCOPED_TRACE(entry.path());
    const Listed scene_list = listed(entry.path());
    const long effects_before = count.effects;
    const auto scene = Scene::load(entry.path());
    ASSERT_TRUE(scene) << scene.error().sentence();
    EXPECT_EQ(count.effects - effects_before, static_cast<long>(scene_list.named));
    const Plan plan = Plan::compile(*scene, 1).value();
    ASSERT_EQ(plan.frame_count(), scene_list.frames);
    for (const int frame : frames_to_build(scene_list)) {
      long steps = 0, rows = 0;
      for (const auto& [name, number] : scene_list.present[static_cast<std::size_t>(frame)]) {
        steps += number;
        rows += stages.at(name) == Stage::kRadiance ? number : 0;
      }
      const long steps_before = count.steps, rows_before = count.rows;
      const cv::Mat image = plan.render(frame, 2);
      ASSERT_EQ(count.steps - steps_before, steps) << frame;
      // What works on whole pictures makes the light anew for each thread and moment, and so that
      // of nothing else.
      const bool in_passes =
          std::any_of(kWholePicture.begin(), kWholePicture.end(), [&](const char* name) {
            return scene_list.present[static_cast<std::size_t>(frame)].contains(name);
          });
      const long made = count.rows - rows_before;
      ASSERT_EQ(in_passes ? made % rows : made - rows, 0) << frame;
      ASSERT_GE(made, rows) << frame;
      std::map<std::string, int> built;
      for (const std::string& name : plan.effects(frame)) ++built[name.substr(0, name.find('#'))];
      ASSERT_EQ(built, scene_list.present[static_cast<std::size_t>(frame)]) << frame;
      partly += steps < static_cast<long>(scene_list.named);
    }
    EXPECT_EQ(count.effects - effects_before, static_cast<long>(scene_list.named));
  }
  EXPECT_GT(partly, 10);
}

TEST(Presence, EntriesSayWhatIsThereAndWhen) {
  const Plan plan =
      plan_of(scene_text("  - {use: quantisation}\n  - {use: read, sd: 1, from: 1}\n"
                         "  - {use: shot, gain: 0.1, until: 2}\n"));
  const auto entries = plan.entries();
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].name, "shot");
  EXPECT_EQ(entries[0].first, 0);
  EXPECT_EQ(entries[0].last, 1);
  EXPECT_EQ(entries[1].name, "read");
  EXPECT_EQ(entries[1].first, 1);
  EXPECT_EQ(entries[1].last, 2);
  EXPECT_EQ(entries[2].name, "quantisation");
  for (const auto& entry : entries) EXPECT_FALSE(entry.sentence.empty()) << entry.name;
}

}  // namespace
}  // namespace alltact
