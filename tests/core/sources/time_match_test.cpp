// Recordings of two fingers, their frames joined by time.
#include "core/sources/file_source.h"

#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(TimeMatch, TakesTheFrameNearestInTime) {
  const FrameTimes ours{1000 * kMs, 1033 * kMs, 1067 * kMs, 1100 * kMs};
  const FrameTimes other{990 * kMs, 1040 * kMs, 1090 * kMs, 1140 * kMs};
  const std::vector<std::size_t> expected{0, 1, 2, 2};
  const std::vector<double> later{-10, 7, 23, -10};
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const MatchedFrame beside = match_frame(i, ours, other, other.size());
    EXPECT_EQ(beside.number, expected[i]) << i;
    EXPECT_EQ(beside.by, MatchedBy::kTime);
    EXPECT_NEAR(beside.later_ms, later[i], 1e-9);
  }
}

TEST(TimeMatch, LostFramesLeaveNoShiftBehind) {
  FrameTimes ours, other;
  for (int i = 0; i < 100; ++i) {
    ours.push_back(i * 20 * kMs);
    if (i < 30 || i >= 50) other.push_back(i * 20 * kMs + kMs);
  }
  EXPECT_EQ(other[match_frame(90, ours, other, other.size()).number], 90 * 20 * kMs + kMs);
  EXPECT_EQ(match_frame(35, ours, other, other.size()).number, 29U);
}

TEST(TimeMatch, RecordingsOfDifferentTimesBeginTogether) {
  const FrameTimes ours{0, 100 * kMs, 200 * kMs}, other{9000 * kMs, 9050 * kMs, 9100 * kMs};
  const MatchedFrame beside = match_frame(1, ours, other, other.size());
  EXPECT_EQ(beside.by, MatchedBy::kBeginning);
  EXPECT_EQ(beside.number, 2U);
  EXPECT_NEAR(beside.later_ms, 0, 1e-9);
  EXPECT_EQ(match_frame(2, ours, other, other.size()).number, 2U) << "the last of a shorter one";
}

TEST(TimeMatch, WithoutTimesTheNumberCounts) {
  EXPECT_EQ(match_frame(3, {}, {0, kMs}, 2).number, 1U);
  EXPECT_EQ(match_frame(3, {}, {}, 10).number, 3U);
  EXPECT_EQ(match_frame(0, {kMs}, {}, 10).by, MatchedBy::kNumber);
}

}  // namespace
}  // namespace alltact
