#include "calibration/presses/guided_presses.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kRate = 30;  // frames a second

class PressTakerTest : public testing::Test {
 protected:
  /// A disc on noise, `at_px` from the left.
  FramePtr frame(double at_px) {
    auto frame = std::make_shared<Frame>();
    frame->grey = cv::Mat(180, 320, CV_8UC1);
    cv::RNG noise(++number_);
    noise.fill(frame->grey, cv::RNG::NORMAL, 120, 1);
    cv::circle(frame->grey, cv::Point(static_cast<int>(at_px), 90), 30, 60, cv::FILLED);
    frame->origin = "/dev/video9";
    frame->sequence = number_;
    frame->time_ns = std::llround(1e9 * now_s());
    return frame;
  }
  [[nodiscard]] double now_s() const { return static_cast<double>(number_) / kRate; }
  std::optional<PressTaker::Taken> see(double at_px,
                                       const std::optional<DarkPatch>& contact = std::nullopt) {
    const FramePtr next = frame(at_px);
    return taker_.see(next, contact, now_s());
  }
  void see_still(int frames) {
    for (int i = 0; i < frames; ++i) ASSERT_FALSE(see(100));
  }
  PressTaker taker_;
  std::uint64_t number_ = 0;
};

TEST_F(PressTakerTest, TakesAtOnceWhatIsHeldAlready) {
  see_still(20);
  const auto taken = taker_.request(now_s());
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->of, PressTaker::kBurst);
  EXPECT_EQ(taken->frame->sequence, number_);
  cv::Scalar mean, sd;
  cv::meanStdDev(taken->frame->grey(cv::Rect(200, 0, 100, 180)), mean, sd);
  EXPECT_LT(sd[0], 0.5) << "a quarter, but for whole levels";
  EXPECT_EQ(taker_.state(), PressTaker::State::kIdle);
}

TEST_F(PressTakerTest, WaitsForWhatMovesToBeHeld) {
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(see(60 + 4 * i));
  EXPECT_FALSE(taker_.request(now_s()));
  for (int i = 10; i < 20; ++i) EXPECT_FALSE(see(60 + 4 * i));
  EXPECT_EQ(taker_.state(), PressTaker::State::kWaits);
  std::optional<PressTaker::Taken> taken;
  int held = 0;
  for (; !taken; ++held) taken = see(200);
  EXPECT_EQ(held, static_cast<int>(PressTaker::kBurst));
  EXPECT_EQ(taken->of, PressTaker::kBurst);
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(see(200)) << "one press, one picture";
}

TEST_F(PressTakerTest, TakesWhatWasHeldForAMoment) {
  EXPECT_FALSE(taker_.request(0));
  see_still(6);
  const auto taken = see(180);
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->of, 6U);
  EXPECT_EQ(taken->frame->sequence, 6U) << "without the frame that moved";
}

TEST_F(PressTakerTest, RefusesWhatIsNeverHeld) {
  EXPECT_FALSE(taker_.request(0));
  for (int i = 0; i < 149; ++i) {
    EXPECT_FALSE(see(60 + 5 * (i % 40)));
    EXPECT_EQ(taker_.state(), PressTaker::State::kWaits);
  }
  EXPECT_FALSE(see(60));
  EXPECT_EQ(taker_.state(), PressTaker::State::kRefused) << "after five seconds";
  // Wanted again, it is waited for again.
  EXPECT_FALSE(taker_.request(now_s()));
  EXPECT_EQ(taker_.state(), PressTaker::State::kWaits);
}

TEST_F(PressTakerTest, BelievesAContactThatHoldsStillInLightThatFlickers) {
  const auto contact = [](double along_mm) {
    DarkPatch patch;
    patch.position_mm = {along_mm, 0};
    patch.darkness = 0.2;
    return patch;
  };
  EXPECT_FALSE(taker_.request(0));
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(see(60 + 5 * (i % 40), contact(0.5 * i)));
  const double began_s = now_s();
  std::optional<PressTaker::Taken> taken;
  for (int i = 0; !taken && i < 100; ++i) taken = see(60 + 5 * (i % 40), contact(20));
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->of, 1U);
  EXPECT_NEAR(now_s() - began_s, StationaryContactDetector::kHold_s, 2.5 / kRate);
}

TEST_F(PressTakerTest, TakesTheLastFrameOfASourceThatHasEnded) {
  EXPECT_FALSE(taker_.end());
  EXPECT_FALSE(see(100));
  EXPECT_FALSE(see(140));
  EXPECT_FALSE(taker_.end()) << "nothing is wanted";
  EXPECT_FALSE(taker_.request(now_s()));
  const auto taken = taker_.end();
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->of, 1U);
  EXPECT_EQ(taken->frame->sequence, 2U);
}

TEST_F(PressTakerTest, FramesOfAnotherSourceAreOthers) {
  see_still(8);
  number_ = 2;  // the same source from its beginning
  EXPECT_FALSE(see(100));
  EXPECT_FALSE(taker_.request(now_s()));
  EXPECT_EQ(taker_.state(), PressTaker::State::kWaits);
}

}  // namespace
}  // namespace alltact
