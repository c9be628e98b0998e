// The finger that is shown live: measured as far as it is known, and a picture in any case.
#include "calibration/live/live_finger.h"

#include "core/simulation/plan.h"
#include "tests/support/temporary_folder.h"

#include <chrono>

#include <gtest/gtest.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

const fs::path kScene = fs::path(ALLTACT_SOURCE_DIR) / "resources/scenes/studio_finger.yaml";

class LiveFingerTest : public testing::Test {
 protected:
  [[nodiscard]] FramePtr frame_of(const cv::Mat& grey) {
    auto frame = std::make_shared<Frame>();
    frame->grey = grey;
    frame->name = "frame";
    frame->origin = "/dev/video9";
    frame->sequence = next_++;
    return frame;
  }
  [[nodiscard]] FramePtr frame(int number) { return frame_of(plan_.render(number)); }

  /// Publishes a frame and waits for its view.
  std::shared_ptr<const LiveView> shown(const FramePtr& frame) {
    hub_.publish(frame);
    std::shared_ptr<const LiveView> view;
    wait_until([&] {
      if (auto newest = finger_.take()) view = newest;
      return view && view->result.frame == frame;
    });
    EXPECT_TRUE(view);
    return view;
  }

  template <class Condition>
  static bool wait_until(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
  }
  [[nodiscard]] bool wait_for(FingerState state) const {
    return wait_until([&] { return finger_.status().state == state; });
  }

  Plan plan_ = Plan::compile(Scene::load(kScene).value(), 3).value();
  std::uint64_t next_ = 0;
  FrameHub hub_;
  LiveFinger finger_{hub_, [] {}};
};

TEST_F(LiveFingerTest, ShowsTheEdgesOfAFingerThatNobodyDescribed) {
  const auto view = shown(frame(70));
  EXPECT_FALSE(view->problem);
  EXPECT_TRUE(view->result.edges);
  EXPECT_FALSE(view->result.shape || view->result.markers);
  EXPECT_EQ(is_face_pressed(view->result), std::nullopt);
  EXPECT_EQ(finger_.status().state, FingerState::kNone);
}

TEST_F(LiveFingerTest, ShowsMarkersAndTouchOfADescribedOneBeforeItsReference) {
  finger_.open_scene(kScene);
  ASSERT_TRUE(wait_for(FingerState::kReady));
  EXPECT_FALSE(finger_.status().has_reference);
  std::shared_ptr<const LiveView> view;
  for (int i = 0; i < 8; ++i) view = shown(frame(i));
  EXPECT_TRUE(view->result.shape && view->result.markers);
  EXPECT_EQ(is_face_pressed(view->result), false);
  EXPECT_EQ(is_face_pressed(shown(frame(70))->result), true);
  finger_.open({});
  EXPECT_FALSE(shown(frame(71))->result.shape);
}

TEST_F(LiveFingerTest, ForgetsWhenAFrameDoesNotFollowTheLastOne) {
  finger_.open_scene(kScene);
  ASSERT_TRUE(wait_for(FingerState::kReady));
  for (int i = 0; i < 8; ++i) static_cast<void>(shown(frame(i)));
  next_ = 0;  // the source begins anew
  EXPECT_EQ(is_face_pressed(shown(frame(0))->result), std::nullopt);
}

TEST_F(LiveFingerTest, ShowsAPictureOfAnotherSizeAsItCameAndSaysWhy) {
  finger_.open_scene(kScene);
  ASSERT_TRUE(wait_for(FingerState::kReady));
  finger_.set_layers({true, true});
  const cv::Mat small = plan_.render(0)(cv::Rect(0, 0, 480, 270)).clone();
  const auto view = shown(frame_of(small));
  ASSERT_TRUE(view->problem);
  EXPECT_NE(view->problem->sentence().find("480 x 270 px"), std::string::npos);
  EXPECT_EQ(view->result.grey.data, small.data);
  EXPECT_FALSE(view->result.edges);
  EXPECT_EQ(is_face_pressed(view->result), std::nullopt);
  EXPECT_EQ(view->faults_layer.size(), small.size());
  EXPECT_FALSE(shown(frame(1))->problem);
}

TEST_F(LiveFingerTest, TellsWhichFingerMeasuredAViewWhileTheNextIsLoaded) {
  EXPECT_EQ(shown(frame(0))->opened, 0U);
  finger_.open_scene(kScene);
  EXPECT_EQ(finger_.status().opened, 1U) << "from the moment it is asked for";
  const auto meanwhile = shown(frame(1));
  EXPECT_EQ(meanwhile->opened, meanwhile->result.shape ? 1U : 0U);
  ASSERT_TRUE(wait_for(FingerState::kReady));
  EXPECT_EQ(finger_.status().opened, 1U);
  EXPECT_TRUE(wait_until([&] { return shown(frame(2))->opened == 1; }));
  finger_.open({});
  EXPECT_EQ(finger_.status().opened, 2U);
  EXPECT_TRUE(wait_until([&] { return shown(frame(3))->opened == 2; }));
}

TEST_F(LiveFingerTest, MeasuresTheLastFrameAgainWithAFingerThatIsOpenedLater) {
  const auto before = shown(frame(70));
  EXPECT_FALSE(before->result.shape);
  finger_.open_scene(kScene);
  std::shared_ptr<const LiveView> after;
  ASSERT_TRUE(wait_until([&] { return (after = finger_.take()) != nullptr; }));
  EXPECT_EQ(after->result.frame, before->result.frame);
  EXPECT_TRUE(after->result.shape);
}

TEST_F(LiveFingerTest, GoesOnWithTheEdgesWhereTheFingerCannotBeRead) {
  const test::TemporaryFolder folder;
  finger_.open(folder.path());
  ASSERT_TRUE(wait_for(FingerState::kFailed));
  EXPECT_TRUE(finger_.status().problem);
  EXPECT_FALSE(finger_.status().finger);
  EXPECT_TRUE(shown(frame(0))->result.edges);
}

}  // namespace
}  // namespace alltact
