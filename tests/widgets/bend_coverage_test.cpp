// Poses that are put in by hand: what is told of them follows from the definition.
#include "widgets/recording/bend_coverage.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr int kPerRow = 3;

/// Two rows at rest, then moved: both along u by `bend`, across by `sway`, against each other along
/// u by `twist`.
Markers layout(double bend = 0, double sway = 0, double twist = 0) {
  Markers markers;
  for (int row = 0; row < 2; ++row)
    for (int i = 0; i < kPerRow; ++i)
      markers.push_back({100.0 + 50 * i + bend + (row == 0 ? twist : -twist),
                         (row == 0 ? 40.0 : 200.0) + sway,
                         true,
                         0.1});
  return markers;
}

TEST(BendPose, TellsBendSwayAndTwistApart) {
  const auto pose = bend_pose(layout(7, -3, 2), layout(), true);
  ASSERT_TRUE(pose);
  EXPECT_DOUBLE_EQ(pose->bend_px, 7);
  EXPECT_DOUBLE_EQ(pose->sway_px, -3);
  EXPECT_DOUBLE_EQ(pose->twist_px, 2);
}

TEST(BendPose, FollowsTheFingerNotThePicture) {
  const auto pose = bend_pose(layout(7, -3, 2), layout(), false);
  ASSERT_TRUE(pose);
  EXPECT_DOUBLE_EQ(pose->bend_px, -7);  // away from the tip, which lies at small u
  EXPECT_DOUBLE_EQ(pose->sway_px, -3);
  EXPECT_DOUBLE_EQ(pose->twist_px, -2);
}

TEST(BendPose, IsNotGuessedFromTooFewMarkers) {
  Markers hidden = layout(5);
  for (int i = 0; i < 4; ++i) hidden[static_cast<std::size_t>(i)].seen = false;
  EXPECT_FALSE(bend_pose(hidden, layout(), true));
  hidden[0].seen = true;  // half of them
  EXPECT_TRUE(bend_pose(hidden, layout(), true));
  hidden.pop_back();
  EXPECT_FALSE(bend_pose(hidden, layout(), true));
  EXPECT_FALSE(bend_pose({}, {}, true));
}

TEST(BendCoverage, MissesEveryDirectionAtFirstAndNoneInTheEnd) {
  BendCoverage coverage;
  coverage.begin({10, 10, 4});
  EXPECT_EQ(coverage.picture().missing().size(), kBendDirections);
  EXPECT_FALSE(coverage.picture().is_enough());
  coverage.add(layout(), true);
  coverage.add(layout(10, 0, 0), true);
  coverage.add(layout(0, -10, 0), true);
  EXPECT_THAT(coverage.picture().missing(),
              testing::ElementsAre(BendDirection::kTowards,
                                   BendDirection::kDown,
                                   BendDirection::kTwistRight,
                                   BendDirection::kTwistLeft));
  coverage.add(layout(-9.9, 10, 4), true);  // nearly
  EXPECT_THAT(coverage.picture().missing(),
              testing::ElementsAre(BendDirection::kTowards, BendDirection::kTwistLeft));
  coverage.add(layout(-10, 0, -4), true);
  EXPECT_TRUE(coverage.picture().is_enough());
  EXPECT_EQ(coverage.picture().poses, 5U);
}

TEST(BendCoverage, CountsPosesWhereTheyWere) {
  BendCoverage coverage;
  coverage.begin({10, 10, 4}, layout());
  for (int i = 0; i < 3; ++i) coverage.add(layout(), true);
  coverage.add(layout(1000, 0, 0), true);  // beyond the picture: its last column
  constexpr int n = BendPicture::kCells;
  const auto& visits = coverage.picture().visits;
  EXPECT_EQ(visits[n / 2 * n + n / 2], 3U);
  EXPECT_EQ(visits[n / 2 * n + n - 1], 1U);
  EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0U), 4U);
}

TEST(BendCoverage, HasNoPoseNowWhereMarkersAreHidden) {
  BendCoverage coverage;
  coverage.begin({10, 10, 4}, layout());
  coverage.add(layout(3), true);
  EXPECT_TRUE(coverage.picture().now);
  coverage.add_nothing();
  EXPECT_FALSE(coverage.picture().now);
  EXPECT_GT(coverage.picture().reached[0], 0.29);  // what was reached stays
}

TEST(BendCoverage, ForgetsAnEarlierRecording) {
  BendCoverage coverage;
  coverage.begin({10, 10, 4}, layout());
  coverage.add(layout(12, 0, 0), true);
  coverage.begin({10, 10, 4}, layout());
  EXPECT_EQ(coverage.picture().poses, 0U);
  EXPECT_EQ(coverage.picture().missing().size(), kBendDirections);
}

}  // namespace
}  // namespace alltact
