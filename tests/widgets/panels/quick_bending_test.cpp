#include "widgets/panels/recording_checks.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr double kFrames_per_s = 30;

/// Six dots of a picture 1000 px wide, all moved sideways.
FrameResult frame_at(int number, double moved_px, const char* source = "camera") {
  FrameResult result;
  auto frame = std::make_shared<Frame>();
  frame->time_ns = 1'000'000'000 + static_cast<std::int64_t>(1e9 * number / kFrames_per_s);
  frame->origin = source;
  result.frame = frame;
  result.grey = cv::Mat(10, 1000, CV_8UC1, cv::Scalar(0));
  result.markers.emplace();
  for (int i = 0; i < 6; ++i) result.markers->push_back({100.0 * i, 50 + moved_px, true, 0.1});
  return result;
}

TEST(QuickBending, IsToldByTheSpeedOfTheMarkers) {
  QuickBending slow, quick;
  // 30 and 300 px a second of 1000 px.
  for (int i = 0; i < 30; ++i) {
    EXPECT_FALSE(slow.is_quick(frame_at(i, 1.0 * i))) << i;
    EXPECT_EQ(quick.is_quick(frame_at(i, 10.0 * i)), i > 0) << i;
  }
}

TEST(QuickBending, EndsWhenThePictureHasSettled) {
  QuickBending bending;
  EXPECT_FALSE(bending.is_quick(frame_at(0, 0)));
  EXPECT_TRUE(bending.is_quick(frame_at(1, 20)));
  const int settled = 1 + static_cast<int>(QuickBending::kSettles_s * kFrames_per_s);
  for (int i = 2; i < settled; ++i) EXPECT_TRUE(bending.is_quick(frame_at(i, 20))) << i;
  for (int i = settled + 1; i < settled + 20; ++i)
    EXPECT_FALSE(bending.is_quick(frame_at(i, 20))) << i;
}

TEST(QuickBending, AnotherSourceAndOneThatBeginsAnewDoNotMove) {
  QuickBending bending;
  EXPECT_FALSE(bending.is_quick(frame_at(5, 0)));
  EXPECT_FALSE(bending.is_quick(frame_at(6, 200, "video")));
  EXPECT_FALSE(bending.is_quick(frame_at(0, 0, "video"))) << "from its beginning";
}

TEST(QuickBending, MarkersThatAreNotSeenTellNothing) {
  QuickBending bending;
  EXPECT_FALSE(bending.is_quick(frame_at(0, 0)));
  FrameResult hidden = frame_at(1, 200);
  for (Marker& marker : *hidden.markers) marker.seen = false;
  EXPECT_FALSE(bending.is_quick(hidden));
  hidden.markers.reset();
  EXPECT_FALSE(bending.is_quick(hidden));
}

}  // namespace
}  // namespace alltact
