// The rows of markers before there is a reference recording, in pictures drawn by hand.
#include "core/sensing/markers/marker_tracker.h"
#include "tests/support/marked_finger.h"

#include <cstdio>
#include <ctime>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using test::Bend;
using test::MarkedFinger;

Bend slow(int frame) {
  const double t = 0.05 * frame;
  return {0.25 * std::sin(t), 0.15 * std::cos(2 * t), 5 * std::sin(1.5 * t), 0.02 * std::cos(t)};
}

/// Of the marker furthest off.
double worst_px(const Markers& markers, const MarkedFinger& finger, const Bend& bend) {
  const Eigen::VectorXd truth = finger.layout(bend);
  double worst = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    const auto i = static_cast<Eigen::Index>(2 * m);
    worst = std::max(worst, std::hypot(markers[m].u - truth[i], markers[m].v - truth[i + 1]));
  }
  return worst;
}

std::vector<MarkedFinger> followed_fingers() {
  std::vector<MarkedFinger> fingers(3);
  fingers[1].dot_contrast = -30;  // dark dots
  fingers[1].side_level = 50;
  fingers[2].width = 1920, fingers[2].height = 1080, fingers[2].focal = 1048;
  fingers[2].mirrored = true;
  return fingers;
}

TEST(EvenRows, FollowTheFingerWithoutBeingToldThePolarity) {
  for (const MarkedFinger& finger : followed_fingers()) {
    std::mt19937 random(7);
    EvenRows rows({finger.per_row, Polarity::kAuto});
    std::vector<Dot> dots;
    double first_ms = 0, later_ms = 0, worst = 0;
    constexpr int kFrames = 16;
    for (int i = 0; i < kFrames; ++i) {
      const Bend bend = slow(i < 8 ? i : i + 40);  // in between it jumps
      const cv::Mat grey = finger.with_noise(finger.clean(bend), random);
      const FaceShape shape = finger.shape(bend);
      const std::clock_t start = std::clock();
      const auto markers = rows(grey, shape, dots);
      const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      (i == 0 || i == 8 ? first_ms : later_ms) += ms;
      ASSERT_TRUE(markers) << i;
      ASSERT_EQ(markers->size(), static_cast<std::size_t>(2 * finger.per_row));
      EXPECT_TRUE(dots.empty());
      worst = std::max(worst, worst_px(*markers, finger, bend));
    }
    std::printf("[ figures  ] worst %.2f px; %.2f ms to find, %.2f ms to follow\n", worst,
                first_ms / 2, later_ms / (kFrames - 2));
    EXPECT_LT(worst, 0.5);
  }
}

TEST(EvenRows, AreNotPlainWhileAMarkerIsHiddenAndComeBack) {
  std::mt19937 random(8);
  const MarkedFinger finger;
  EvenRows rows({finger.per_row, Polarity::kAuto});
  std::vector<Dot> dots;
  for (int i = 0; i < 18; ++i) {
    const bool is_hidden = i >= 5 && i < 12;
    const Bend bend = slow(i);
    const std::vector<int> covered = is_hidden ? std::vector<int>{3} : std::vector<int>{};
    const cv::Mat grey = finger.with_noise(finger.clean(bend, covered), random);
    const auto markers = rows(grey, finger.shape(bend), dots);
    EXPECT_EQ(markers.has_value(), !is_hidden) << i;
    EXPECT_EQ(dots.empty(), !is_hidden) << i;
    if (markers) {
      EXPECT_LT(worst_px(*markers, finger, bend), 0.5) << i;
    }
  }
}

TEST(EvenRows, LearnThePolarityAnewWhenTheyForget) {
  std::mt19937 random(9);
  MarkedFinger bright, dark;
  dark.dot_contrast = -30;
  dark.side_level = 50;
  EvenRows rows({bright.per_row, Polarity::kAuto});
  std::vector<Dot> dots;
  EXPECT_TRUE(rows(bright.with_noise(bright.clean(Bend{}), random), bright.shape(Bend{}), dots));
  rows.forget();
  const auto markers = rows(dark.with_noise(dark.clean(Bend{}), random), dark.shape(Bend{}), dots);
  ASSERT_TRUE(markers);
  EXPECT_LT(worst_px(*markers, dark, Bend{}), 0.5);
}

TEST(EvenRows, AnotherFingerIsLearntEvenUntold) {
  std::mt19937 random(10);
  MarkedFinger bright, dark;
  dark.dot_contrast = -30;
  dark.side_level = 50;
  EvenRows rows({bright.per_row, Polarity::kAuto});
  std::vector<Dot> dots;
  EXPECT_TRUE(rows(bright.with_noise(bright.clean(Bend{}), random), bright.shape(Bend{}), dots));
  bool is_found = false;
  for (int i = 0; i < 10 && !is_found; ++i)
    is_found =
        rows(dark.with_noise(dark.clean(Bend{}), random), dark.shape(Bend{}), dots).has_value();
  EXPECT_TRUE(is_found);
}

TEST(EvenRows, SayNothingOfAPictureWithoutDots) {
  std::mt19937 random(11);
  const MarkedFinger finger;
  std::vector<int> every;
  for (int m = 0; m < 2 * finger.per_row; ++m) every.push_back(m);
  EvenRows rows({finger.per_row, Polarity::kAuto});
  std::vector<Dot> dots;
  const auto markers =
      rows(finger.with_noise(finger.clean(Bend{}, every), random), finger.shape(Bend{}), dots);
  EXPECT_FALSE(markers);
}

}  // namespace
}  // namespace alltact
