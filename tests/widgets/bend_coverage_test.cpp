// Motions that are put in by hand: what is told of them follows from the definition.
#include "widgets/recording/bend_coverage.h"

#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr MotionNeed kNeed{4, 2, 3};

TEST(BendCoverage, MissesEveryDirectionAtFirstAndNoneInTheEnd) {
  BendCoverage coverage;
  coverage.begin(kNeed);
  EXPECT_EQ(coverage.picture().missing().size(), kBendDirections);
  EXPECT_FALSE(coverage.picture().is_enough());
  coverage.add({});
  coverage.add({4, 0, 0});
  coverage.add({0, -2, 0});
  EXPECT_THAT(coverage.picture().missing(),
              testing::ElementsAre(BendDirection::kTowards,
                                   BendDirection::kDown,
                                   BendDirection::kTwistRight,
                                   BendDirection::kTwistLeft));
  coverage.add({-3.9, 2, 3});  // nearly
  EXPECT_THAT(coverage.picture().missing(),
              testing::ElementsAre(BendDirection::kTowards, BendDirection::kTwistLeft));
  coverage.add({-4, 0, -3});
  EXPECT_TRUE(coverage.picture().is_enough());
  EXPECT_EQ(coverage.picture().poses, 5U);
}

TEST(BendCoverage, CountsPosesWhereTheyWere) {
  BendCoverage coverage;
  coverage.begin(kNeed);
  for (int i = 0; i < 3; ++i) coverage.add({});
  coverage.add({1000, 0, 0});  // beyond the picture: its last column
  coverage.add({0, -2.9, 0});  // nearly beyond it: its first row
  constexpr int n = BendPicture::kCells;
  const auto& visits = coverage.picture().visits;
  EXPECT_EQ(visits[n / 2 * n + n / 2], 3U);
  EXPECT_EQ(visits[n / 2 * n + n - 1], 1U);
  EXPECT_EQ(visits[n / 2], 1U);
  EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0U), 5U);
}

TEST(BendCoverage, HasNoPoseNowWhereMarkersAreHidden) {
  BendCoverage coverage;
  coverage.begin(kNeed);
  coverage.add({2, 0, 0});
  EXPECT_TRUE(coverage.picture().now);
  coverage.add_nothing();
  EXPECT_FALSE(coverage.picture().now);
  EXPECT_DOUBLE_EQ(coverage.picture().reached[0], 0.5);  // what was reached stays
}

TEST(BendCoverage, ForgetsAnEarlierRecording) {
  BendCoverage coverage;
  coverage.begin(kNeed);
  coverage.add({5, 0, 0});
  coverage.begin(kNeed);
  EXPECT_EQ(coverage.picture().poses, 0U);
  EXPECT_EQ(coverage.picture().missing().size(), kBendDirections);
}

}  // namespace
}  // namespace alltact
