// The kept session: there and back, kind to damage, and honest about a crash.
#include "app/studio/session.h"
#include "core/base/atomic_file.h"
#include "tests/fuzz/mutations.h"
#include "tests/studio/studio_rig.h"

#include <QTest>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alltact::test {
namespace {

SessionState example() {
  SessionState state;
  state.finger = "/fingers/left \"7\"";
  state.source = {"/scenes/a.yaml"};
  state.page = "record";
  state.view.depth = false;
  state.view.focus = true;
  state.view.depth_top_mm = 2.5;
  state.inspect.options.recording = "/videos/a b.mkv";
  state.inspect.options.comparison = Comparison::kDifference;
  state.inspect.options.with = {OtherMethod::kBody, {}, {}, 0, "/bodies/rod 2.stl"};
  state.inspect.frame = 17;
  state.is_locked = false;
  state.controls["usb-Camera_1-index0"] = {{9963795, "Gain", 17}, {10094850, "Exposure", -3}};
  state.recent_fingers = {"/fingers/left \"7\"", "/fingers/b"};
  state.recent_sources = {"/videos/a b.mkv", "/images"};
  return state;
}

TEST(SessionFile, ComesBackAsItWas) {
  const auto back = session_from_json(session_to_json(example()), "a test");
  ASSERT_TRUE(back) << back.error().sentence();
  EXPECT_EQ(*back, example());
  EXPECT_EQ(session_to_json(*back), session_to_json(example()));
}

TEST(SessionFile, HoldsTheFingerThatIsComparedWith) {
  SessionState state = example();
  state.inspect.options.with = {OtherMethod::kFinger, {}, {}, 4, "/videos/b.mkv", "/fingers/b"};
  const auto back = session_from_json(session_to_json(state), "a test");
  ASSERT_TRUE(back) << back.error().sentence();
  EXPECT_EQ(back->inspect.options.with, state.inspect.options.with);
  state.inspect.options.with.finger.clear();
  EXPECT_EQ(session_from_json(session_to_json(state), "a test")->inspect.options.with.method,
            OtherMethod::kPaper)
      << "without a finger there is nothing to compare with";
}

TEST(SessionFile, WhatIsImpossibleBecomesTheDefault) {
  const auto state = session_from_json(
      R"({"format": "alltact-session/1", "place": "moon", "locked": 7, "source": "x",
          "view": {"depth_top_mm": -4, "edges": "yes", "markers": false}, "controls": [1, 2],
          "from_a_later_version": {}})",
      "a test");
  ASSERT_TRUE(state) << state.error().sentence();
  SessionState expected;
  expected.page = "moon";  // a later version may have it; which there are the window knows
  expected.view.markers = false;
  EXPECT_EQ(*state, expected);
}

TEST(SessionFile, RefusesWhatIsNone) {
  for (const char* text : {"", "[]", "{}", "null", "{\"format\": \"alltact-session/9\"}"})
    EXPECT_FALSE(session_from_json(text, "a test")) << text;
}

TEST(SessionFile, MeetsEveryTruncation) {
  const std::string whole = session_to_json(example());
  for (std::size_t length = 0; length + 2 < whole.size(); ++length)
    EXPECT_FALSE(session_from_json(whole.substr(0, length), "a test")) << length;
}

TEST(SessionFile, MeetsDamageAndKeepsWhatItTook) {
  std::mt19937 random(20);
  for (int i = 0; i < 2000; ++i) {
    const std::string text = damaged(session_to_json(example()), random);
    const auto state = session_from_json(text, "a test");
    if (!state) {
      EXPECT_LT(state.error().sentence().size(), 1000U);
      continue;
    }
    const auto again = session_from_json(session_to_json(*state), "a test");
    ASSERT_TRUE(again) << text;
    EXPECT_EQ(*again, *state) << text;
  }
}

TEST(SessionFile, OfAPlaceThatTheWindowDoesNotHaveOpensTheFirst) {
  const TemporaryFolder folder;
  StudioOptions options;
  options.session_folder = folder / "session";
  SessionState kept;
  kept.source = {MadeFingers::get().bending()};
  kept.page = "moon";
  { SessionStore(options.session_folder).keep(kept); }
  Studio studio(options);
  studio.window().go_to("record");
  studio.window().go_to("moon");
  EXPECT_TRUE(studio.find<QToolButton>("Live")->isChecked());
  studio.click("Go on with source bending.yaml");
  ASSERT_TRUE(studio.wait_for_picture());
  EXPECT_TRUE(studio.window().findChild<LivePage*>()->isVisible());
  EXPECT_TRUE(wait_until([&] {
    const SessionStore other(options.session_folder);
    return other.last() && other.last()->source == kept.source && other.last()->page == "live";
  }));
}

TEST(SessionStore, KeepsTheLatest) {
  const TemporaryFolder folder;
  {
    SessionStore keeper(folder / "session");
    EXPECT_FALSE(keeper.last());
    for (int i = 1; i <= 50; ++i) {
      SessionState state = example();
      state.view.depth_top_mm = 0.1 * i;
      keeper.keep(state);
    }
  }
  SessionStore again(folder / "session");
  ASSERT_TRUE(again.last());
  EXPECT_DOUBLE_EQ(again.last()->view.depth_top_mm, 5.0);
  EXPECT_FALSE(again.has_crashed());
}

TEST(SessionStore, NoticesThatTheLastProgramDied) {
  const TemporaryFolder folder;
  { SessionStore(folder / "session").keep(example()); }
  leave_as_after_a_crash(folder / "session");
  const SessionStore keeper(folder / "session");
  EXPECT_TRUE(keeper.has_crashed());
  EXPECT_EQ(*keeper.last(), example());
}

TEST(SessionStore, ASecondProgramNeitherWritesNorClaimsACrash) {
  const TemporaryFolder folder;
  SessionStore first(folder / "session");
  first.keep(example());
  {
    SessionStore second(folder / "session");
    EXPECT_FALSE(second.has_crashed());
    second.keep(SessionState());
  }
  QTest::qWait(600);
  const auto text = read_file(folder / "session/session.json");
  ASSERT_TRUE(text) << text.error().sentence();
  EXPECT_EQ(*text, session_to_json(example()));
}

TEST(SessionStore, SaysWhyItCannotKeep) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_file_atomically(folder / "file", "not a folder"));
  const SessionStore keeper(folder / "file/session");
  ASSERT_TRUE(keeper.problem());
  EXPECT_NE(keeper.problem()->where.english().find("file/session"), std::string::npos);
}

}  // namespace
}  // namespace alltact::test
