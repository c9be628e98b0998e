// The list before the first recording, on pictures drawn with a known blur, brightness and dots.
#include "calibration/checks/rig_check.h"

#include "core/sensing/face/face_edges.h"
#include "tests/support/marked_finger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

/// What the pipeline tells of a drawn finger: its edges, its face, its dots.
FrameResult drawn(const test::MarkedFinger& finger, const test::Bend& bend, unsigned seed) {
  FrameResult result;
  std::mt19937 random(seed);
  result.grey = finger.with_noise(finger.clean(bend), random);
  result.edges = FaceEdgeFinder()(result.grey).value();
  result.shape = finger.shape(bend);
  return result;
}

const RigFinding& finding(const std::vector<RigFinding>& findings, RigItem item) {
  for (const RigFinding& one : findings)
    if (one.item == item) return one;
  throw std::runtime_error("there is no such item");
}

TEST(RigCheck, EdgesAreAsWideAsTheirBlurMakesThem) {
  double before = 0;
  for (const double blur : {0.7, 1.5, 3.0}) {
    test::MarkedFinger finger;
    finger.blur = blur;
    const FrameResult result = drawn(finger, {}, 3);
    for (const bool at_tip : {false, true}) {
      const auto width = edge_sharpness_px(result, at_tip);
      ASSERT_TRUE(width);
      // A step blurred by a Gaussian rises at most by 1 / (sd sqrt(2 pi)) a pixel; the pixel itself
      // and noise blur and steepen it a little.
      const double expected = std::sqrt(2 * M_PI) * std::sqrt(blur * blur + 0.3);
      EXPECT_NEAR(*width, expected, 0.3 * expected) << blur << (at_tip ? " tip" : " base");
    }
    const double now = *edge_sharpness_px(result, false);
    EXPECT_GT(now, before);
    before = now;
  }
}

TEST(RigCheck, SaysWhatToDoAboutBlurAndLight) {
  test::MarkedFinger blurred;
  blurred.blur = 4;
  RigCheck check;
  check.add(drawn(blurred, {}, 4), 0);
  const auto focus = finding(check.findings(12), RigItem::kFocusTip);
  EXPECT_EQ(focus.state, RigState::kBad);
  EXPECT_THAT(focus.advice.english(), HasSubstr("turn the lens"));
  test::MarkedFinger bright;
  bright.face_level = 300;
  check.begin();
  check.add(drawn(bright, {}, 5), 0);
  for (int i = 1; i < 12; ++i) check.add(drawn(bright, {}, 5), 0.03 * i);
  const auto light = finding(check.findings(12), RigItem::kBrightness);
  EXPECT_EQ(light.state, RigState::kBad);
  EXPECT_THAT(light.advice.english(), HasSubstr("dim the lamp"));
  test::MarkedFinger dark;
  dark.face_level = 45;
  dark.side_level = 15;
  dark.dark_level = 5;
  check.begin();
  check.add(drawn(dark, {}, 6), 0);
  EXPECT_EQ(finding(check.findings(12), RigItem::kBrightness).state, RigState::kDoubtful);
}

TEST(RigCheck, WatchesTheLampForTenSecondsOfRest) {
  const FrameResult still = drawn({}, {}, 7);
  RigCheck check;
  for (double time_s = 0; time_s < 9; time_s += 0.5) check.add(still, time_s);
  EXPECT_EQ(finding(check.findings(12), RigItem::kLamp).state, RigState::kWaiting);
  for (double time_s = 9; time_s <= 10.5; time_s += 0.5) check.add(still, time_s);
  EXPECT_EQ(finding(check.findings(12), RigItem::kLamp).state, RigState::kFine);
  // A lamp that falls by 5 %.
  FrameResult fallen = still;
  fallen.grey = 0.95 * still.grey;
  check.add(fallen, 11);
  const auto lamp = finding(check.findings(12), RigItem::kLamp);
  EXPECT_EQ(lamp.state, RigState::kBad);
  EXPECT_THAT(lamp.sentence.english(), HasSubstr("5."));
  // A finger that moves is not told from a lamp that does.
  test::Bend bent;
  bent.curl = 0.15;
  check.add(drawn({}, bent, 8), 11.5);
  EXPECT_EQ(finding(check.findings(12), RigItem::kLamp).state, RigState::kWaiting);
}

TEST(RigCheck, CountsDots) {
  FrameResult result = drawn({}, {}, 9);
  RigCheck check;
  EXPECT_EQ(finding(check.findings(12), RigItem::kDots).state, RigState::kWaiting);
  result.dots.resize(12);
  check.add(result, 0);
  EXPECT_EQ(finding(check.findings(12), RigItem::kDots).state, RigState::kFine);
  result.dots.resize(11);
  check.add(result, 0.1);
  EXPECT_EQ(finding(check.findings(12), RigItem::kDots).state, RigState::kDoubtful);
  result.dots.resize(3);
  check.add(result, 0.2);
  const auto dots = finding(check.findings(12), RigItem::kDots);
  EXPECT_EQ(dots.state, RigState::kBad);
  EXPECT_EQ(dots.sentence.english(), "3 of 12 dots are found");
}

}  // namespace
}  // namespace alltact
