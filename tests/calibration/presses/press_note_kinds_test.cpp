#include "calibration/presses/press_note_kinds.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alltact {
namespace {

const PressNoteKind& kind_of(std::string_view flag) {
  const auto& kinds = press_note_kinds();
  return *std::find_if(kinds.begin(), kinds.end(),
                       [&](const PressNoteKind& kind) { return flag == kind.flag; });
}

PressSet press_set(std::string_view flag, const std::string& text, PressSet before = {}) {
  const Status status = set_press_note(kind_of(flag), text, before);
  EXPECT_TRUE(status) << status.error().sentence();
  return before;
}

TEST(PressSayings, AreReadAsTheCommandLineWritesThem) {
  EXPECT_EQ(press_set("depth", "a=b=1.25+-0.01").of("a=b").depth, (GivenDepth{1.25, 0.01}));
  EXPECT_EQ(press_set("depth", "p=1.25±0.03").of("p").depth->sd_mm, 0.03);
  EXPECT_EQ(press_set("depth", "p=1.25").of("p").depth->sd_mm, kTypicalDepthSdMm);
  EXPECT_EQ(press_set("step", "p=0.5").of("p").step_mm, 0.5);
  EXPECT_EQ(press_set("body", "p=/a/b=c/rod.stl").of("p=/a/b").body,
            (std::filesystem::current_path() / "c/rod.stl").string());
  EXPECT_EQ(press_set("body", "p=/a/rod.stl").of("p").body, "/a/rod.stl");
  EXPECT_EQ(press_set("other-ball", "p=5").of("p").ball_radius_mm, 5.0);
  EXPECT_EQ(press_set("ball", "p=1.5,-2,48").of("p").ball_mm, Eigen::Vector3d(1.5, -2, 48));
  EXPECT_EQ(press_set("exclude", "p").of("p").excluded, "");
  EXPECT_EQ(press_set("exclude", "p=glove, 1=2").of("p").excluded, "glove, 1=2");
}

TEST(PressSayings, OtherTextsAreRefusedAndSayNothing) {
  const auto refuse = [](const char* flag, const std::vector<const char*>& texts) {
    for (const char* text : texts) {
      PressSet presses;
      const Status status = set_press_note(kind_of(flag), text, presses);
      ASSERT_FALSE(status) << flag << ' ' << text;
      EXPECT_THAT(status.error().what.english(), testing::HasSubstr(kind_of(flag).form));
      EXPECT_EQ(presses, PressSet()) << flag << ' ' << text;
    }
  };
  const std::vector<const char*> no_lengths{"",     "p",   "=1",    "p=",    "p=x",
                                            "p=-1", "p=0", "p=nan", "p=inf", "p=1e9"};
  for (const char* flag : {"depth", "step", "other-ball"}) refuse(flag, no_lengths);
  refuse("depth", {"p=1+-", "p=1+-0", "p=1+--1", "p=+-0.1", "p=1+-nan"});
  refuse("ball", {"", "p", "p=", "p=1,2", "p=1,2,3,4", "=1,2,3", "p=1,2,-3", "p=1,2,nan",
                  "p=1,2,inf", "p=1 2 3", "p=1,2,3x"});
  refuse("body", {"", "p", "p=", "=rod.stl"});
  refuse("exclude", {"", "=why"});
}

TEST(PressSayings, ALaterOneCountsAndCanBeTakenBack) {
  PressSet presses = press_set("depth", "b=1");
  presses = press_set("step", "b=0.5", presses);
  presses = press_set("depth", "b=1.2", presses);
  EXPECT_EQ(presses.of("b").depth->mm, 1.2);
  presses = press_set("depth", "b=none", presses);
  EXPECT_FALSE(presses.of("b").depth);
  EXPECT_EQ(presses.of("b").step_mm, 0.5);
  presses = press_set("step", "b=none", presses);
  EXPECT_EQ(presses, PressSet()) << "of a press of which nothing is said nothing is kept";
  presses = press_set("ball", "b=find", press_set("ball", "b=1,2,3"));
  EXPECT_EQ(presses, PressSet());
}

RC_GTEST_PROP(PressSayings, AllThatIsSaidIsReadBack, ()) {
  const auto number = [] { return static_cast<double>(*rc::gen::inRange(1, 49999)) / 1000; };
  PressSet presses;
  for (const char* name : {"press_3", "it's, 1", "ä b"}) {
    PressNote note;
    if (*rc::gen::arbitrary<bool>()) note.ball_radius_mm = number();
    if (*rc::gen::arbitrary<bool>()) note.depth = GivenDepth{number(), number()};
    if (*rc::gen::arbitrary<bool>()) note.step_mm = number();
    if (*rc::gen::arbitrary<bool>()) note.body = "/a b/it's.stl";
    if (*rc::gen::arbitrary<bool>()) note.ball_mm = {number() - 20, number() - 20, number()};
    if (*rc::gen::arbitrary<bool>()) note.excluded = *rc::gen::element<std::string>("", "a=b, c");
    presses.say(name, note);
  }
  PressSet back;
  for (const auto& [flag, text] : press_note_flags(presses)) back = press_set(flag, text, back);
  RC_ASSERT(back == presses);
}

}  // namespace
}  // namespace alltact
