// What comes back in the place Inspect after a crash.
#include "tests/studio/two_fingers.h"

#include <QSlider>
#include <QSpinBox>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

class InspectAfterACrash : public testing::Test {
 protected:
  SessionState kept() {
    SessionState state;
    state.finger = TwoFingers::get().left();
    state.page = "inspect";
    InspectOptions& options = state.inspect.options;
    options.recording = TwoFingers::get().left_video();
    options.second = SecondFinger{TwoFingers::get().right(), TwoFingers::get().right_video()};
    options.scene.top_mm = 0.7;
    options.a = FacePosition{43.5, -1.25};
    options.with = {OtherMethod::kSetting, "smoothing-px", "0"};
    options.scene.body = false;
    options.scene.difference_top_mm = 0.02;
    options.view_pose = ViewPose{{1, -90, -120}, {0, 0, 60}, {0, -1, 0}};
    state.inspect.frame = 4;
    return state;
  }
  void leave(const SessionState& state) {
    { SessionStore(folder_ / "session").keep(state); }
    leave_as_after_a_crash(folder_ / "session");
  }
  StudioOptions options() {
    StudioOptions options;
    options.session_folder = folder_ / "session";
    return options;
  }
  TemporaryFolder folder_;
};

TEST_F(InspectAfterACrash, WhatWasInspectedComesBack) {
  leave(kept());
  Studio studio(options());
  studio.click("Go on with it");
  auto& place = *studio.window().findChild<InspectPage*>();
  ASSERT_TRUE(wait_until([&] { return place.pair().frames().has_value(); }, 20000));
  EXPECT_TRUE(wait_until([&] { return place.inspection().frame()->number == 4; }));
  EXPECT_TRUE(wait_until([&] { return place.pair().frames()->second->number == 8; }));
  InspectOptions expected = kept().inspect.options;
  if (!VtkView::is_supported()) expected.shown_as = ShownAs::kHeightMap;
  EXPECT_EQ(place.options(), expected);
  EXPECT_EQ(studio.find<QSpinBox>("Current frame")->value(), 5);
  EXPECT_EQ(studio.window().undo_stack().count(), 1);
  studio.window().undo_stack().undo();
  EXPECT_TRUE(place.options().recording.empty());
}

TEST_F(InspectAfterACrash, ARecordingThatHasGoneIsSaid) {
  SessionState state = kept();
  state.inspect.options.recording = folder_ / "grasp.mkv";
  state.inspect.options.second.reset();
  leave(state);
  Studio studio(options());
  studio.click("Go on with it");
  ASSERT_TRUE(wait_until([&] {
    return studio.problems().find("grasp.mkv: this recording no longer exists") !=
           std::string::npos;
  })) << studio.problems();
}

TEST_F(InspectAfterACrash, WhatIsShownIsKeptWhileOneWorks) {
  {
    StudioOptions with = options();
    with.finger = TwoFingers::get().left();
    Studio studio(with);
    studio.window().go_to("inspect");
    auto& place = *studio.window().findChild<InspectPage*>();
    place.open(TwoFingers::get().left_video());
    ASSERT_TRUE(wait_until([&] { return place.inspection().frame() != nullptr; }, 20000));
    studio.find<QSlider>("Frame of the recording")->setValue(2);
    ASSERT_TRUE(wait_until([&] { return place.inspection().frame()->number == 2; }));
    studio.click("Deepest");
    const auto written = [&] {
      const SessionStore other(folder_ / "session");
      return other.last() ? other.last()->inspect : InspectState();
    };
    EXPECT_TRUE(wait_until([&] { return written().frame == 2 && written().options.a; }))
        << "without closing it";
    EXPECT_EQ(written().options.recording, TwoFingers::get().left_video());
  }
}

}  // namespace
}  // namespace alltact::test
