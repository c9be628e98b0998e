// Motions that are put in by hand: what is told of them follows from the definition.
#include "calibration/reference/motion_coverage.h"

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

constexpr MotionNeed kNeed{4, 2, 3};

/// A tip that has moved so from a place in front of the camera.
TipPose at(double bend_mm, double sway_mm, double twist_deg) {
  return {{0, sway_mm, 60 + bend_mm}, {0, 0, 1}, twist_deg * M_PI / 180};
}

/// Coverage whose rest is at(0, 0, 0).
BendCoverage at_rest() {
  BendCoverage coverage;
  coverage.begin(kNeed);
  coverage.add(at(0, 0, 0));
  EXPECT_TRUE(coverage.set_rest());
  coverage.begin(kNeed);
  return coverage;
}

TEST(BendCoverage, MissesEveryDirectionAtFirstAndNoneInTheEnd) {
  BendCoverage coverage = at_rest();
  EXPECT_EQ(coverage.state().missing().size(), kBendDirections);
  EXPECT_FALSE(coverage.state().is_enough());
  coverage.add(at(0, 0, 0));
  coverage.add(at(4.001, 0, 0));
  coverage.add(at(0, -2.001, 0));
  EXPECT_THAT(coverage.state().missing(),
              testing::ElementsAre(BendDirection::kTowards, BendDirection::kDown,
                                   BendDirection::kTwistRight, BendDirection::kTwistLeft));
  coverage.add(at(-3.9, 2.001, 3.001));  // nearly
  EXPECT_THAT(coverage.state().missing(),
              testing::ElementsAre(BendDirection::kTowards, BendDirection::kTwistLeft));
  coverage.add(at(-4.001, 0, -3.001));
  EXPECT_TRUE(coverage.state().is_enough());
  EXPECT_EQ(coverage.state().poses, 5U);
}

TEST(BendCoverage, AsksNoTwistOfAFingerThatHasNone) {
  BendCoverage stiff = at_rest();
  for (const TipPose& pose : {at(4.1, 0, 0.2), at(-4.1, 0, -0.1), at(0, 2.1, 0.3), at(0, -2.1, 0)})
    stiff.add(pose);
  EXPECT_TRUE(stiff.state().is_enough());
  EXPECT_FALSE(stiff.state().is_required(BendDirection::kTwistLeft));
  EXPECT_TRUE(stiff.state().is_required(BendDirection::kAway));
  // One that twists when it is bent has to show both ways.
  stiff.add(at(1, 1, 1.6));
  EXPECT_THAT(stiff.state().missing(),
              testing::ElementsAre(BendDirection::kTwistRight, BendDirection::kTwistLeft));
}

TEST(BendCoverage, CountsPosesWhereTheyWere) {
  BendCoverage coverage = at_rest();
  for (int i = 0; i < 3; ++i) coverage.add(at(0, 0, 0));
  coverage.add(at(1000, 0, 0));  // beyond the picture: its last column
  coverage.add(at(0, -2.9, 0));  // nearly beyond it: its first row
  constexpr int n = BendState::kCells;
  const auto& visits = coverage.state().visits;
  EXPECT_EQ(visits[n / 2 * n + n / 2], 3U);
  EXPECT_EQ(visits[n / 2 * n + n - 1], 1U);
  EXPECT_EQ(visits[n / 2], 1U);
  EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0U), 5U);
}

TEST(BendCoverage, HasNoPoseNowWhereMarkersAreHidden) {
  BendCoverage coverage = at_rest();
  coverage.add(at(2, 0, 0));
  EXPECT_TRUE(coverage.state().now);
  coverage.clear_pose();
  EXPECT_FALSE(coverage.state().now);
  EXPECT_FALSE(coverage.set_rest());
  EXPECT_NEAR(coverage.state().reached[0], 0.5, 1e-12);  // what was reached stays
}

TEST(BendCoverage, ForgetsAnEarlierRecordingButNotTheRestThatWasSet) {
  BendCoverage coverage = at_rest();
  coverage.add(at(5, 0, 0));
  coverage.begin(kNeed);
  EXPECT_EQ(coverage.state().poses, 0U);
  EXPECT_EQ(coverage.state().missing().size(), kBendDirections);
  coverage.add(at(1, 0, 0));
  EXPECT_NEAR(coverage.state().now->bend_mm, 1, 1e-12);
}

// A finger that is held twisted when the recording begins, and then moves both ways alike.
TEST(BendCoverage, TakesTheMiddleForRestHoweverTheRecordingBegins) {
  BendCoverage coverage;
  coverage.begin(kNeed);
  for (int i = 0; i <= 200; ++i) {
    const double turn = 0.05 * i;
    coverage.add(at(8 * std::sin(1.7 * turn), 4 * std::sin(2.3 * turn), 12 * std::cos(turn)));
  }
  EXPECT_TRUE(coverage.state().is_enough());
  const auto& reached = coverage.state().reached;
  const auto part = [&](BendDirection d) { return reached[static_cast<std::size_t>(d)]; };
  EXPECT_NEAR(part(BendDirection::kTwistLeft), part(BendDirection::kTwistRight), 1.6);
  EXPECT_NEAR(part(BendDirection::kTwistLeft) + part(BendDirection::kTwistRight), 24 / 3., 1e-2);
}

// However late somebody says which pose is rest, the poses before are told from it too.
TEST(BendCoverage, TellsPosesBeforeFromTheRestThatIsSetAfterThem) {
  BendCoverage late;
  late.begin(kNeed);
  BendCoverage early = at_rest();
  for (int i = 0; i < 50; ++i) {
    const TipPose pose = at(0.1 * i, 0.03 * i, -0.05 * i);
    late.add(pose);
    early.add(pose);
  }
  late.add(at(0, 0, 0));
  early.add(at(0, 0, 0));
  ASSERT_TRUE(late.set_rest());
  EXPECT_EQ(late.state().reached, early.state().reached);
  EXPECT_EQ(late.state().visits, early.state().visits);
}

}  // namespace
}  // namespace alltact
