// What is kept of forces and contacts, and zeros.
#include "widgets/live/touch_history.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

Force force_of(double fx, double fy) {
  Force force;
  force.axes = 2;
  force.force_N = {fx, fy, 0};
  force.sd_N = {0.1, 0.2, 0};
  force.half_90_N = 1.64 * force.sd_N;
  force.half_95_N = 1.96 * force.sd_N;
  force.in_range = true;
  return force;
}

FrameResult felt(const std::optional<Force>& force, bool has_contact = false) {
  FrameResult result;
  result.force = force;
  if (has_contact) result.contact = FingerContact();
  return result;
}

TEST(TouchHistoryTest, KeepsHalfAMinuteHoweverFastFramesCome) {
  TouchHistory history;
  for (int i = 0; i < 200'000; ++i) history.add(felt(force_of(0.001 * i, 0)), 5 + 0.001 * i);
  ASSERT_FALSE(history.forces().empty());
  EXPECT_LE(history.forces().size(), 1501U);
  EXPECT_GE(history.forces().size(), 1499U);
  EXPECT_NEAR(history.forces().front().time_s, *history.now_s() - 30, 0.021);
  EXPECT_EQ(history.forces().back().time_s, *history.now_s());
  EXPECT_EQ(history.forces().back().force->force_N.x(), 0.001 * 199'999);
}

TEST(TouchHistoryTest, KeepsEveryFrameOfASlowCamera) {
  TouchHistory history;
  for (int i = 0; i < 300; ++i) history.add(felt(force_of(i, 0)), i / 30.0);
  ASSERT_EQ(history.forces().size(), 300U);
  for (int i = 0; i < 300; ++i)
    EXPECT_EQ(history.forces()[static_cast<std::size_t>(i)].force->force_N.x(), i);
}

TEST(TouchHistoryTest, LeavesAHoleWhereFramesAreMissingOrTellNothing) {
  TouchHistory history;
  history.add(felt(force_of(1, 0)), 1.0);
  history.add(felt(std::nullopt), 1.1);
  history.add(felt(force_of(2, 0)), 1.2);
  history.add(felt(force_of(3, 0)), 2.9);  // more than a second later
  std::vector<bool> told;
  for (const auto& reading : history.forces()) told.push_back(reading.force.has_value());
  EXPECT_EQ(told, (std::vector<bool>{true, false, true, false, true}));
}

TEST(TouchHistoryTest, BeginsAnewWhenTimeGoesBack) {
  TouchHistory history;
  history.add(felt(force_of(1, 0), true), 10);
  history.add(felt(force_of(2, 0), true), 3);
  ASSERT_EQ(history.forces().size(), 1U);
  EXPECT_EQ(history.forces().front().force->force_N.x(), 2);
  EXPECT_EQ(history.contacts().size(), 1U);
}

TEST(TouchHistoryTest, TellsContactsApartAlsoThoseThatEndedBetweenTwoViews) {
  TouchHistory history;
  const auto touched = [](double held_s) {
    FrameResult result = felt(std::nullopt, true);
    result.contact->held_s = held_s;
    return result;
  };
  history.add(felt(std::nullopt), 0.0);
  history.add(touched(0.05), 1.0);  // began before it was looked at
  history.add(touched(0.15), 1.1);
  history.add(felt(std::nullopt), 1.2);
  history.add(touched(0.0), 2.0);
  history.add(touched(0.1), 2.5);  // another one: this began at 2.4
  ASSERT_EQ(history.contacts().size(), 3U);
  EXPECT_NEAR(history.contacts()[0].from_s, 0.95, 1e-12);
  EXPECT_NEAR(history.contacts()[0].to_s, 1.1, 1e-12);
  EXPECT_TRUE(history.contacts()[0].has_ended);
  EXPECT_TRUE(history.contacts()[1].has_ended);
  EXPECT_NEAR(history.contacts()[2].from_s, 2.4, 1e-12);
  EXPECT_FALSE(history.contacts()[2].has_ended);
}

TEST(TouchHistoryTest, AContactLastsAsLongAsItsFramesStated) {
  TouchHistory history;
  double stated_s = 0;
  const auto add = [&](PushedFace face, double time_s, double held_s) {
    FrameResult result = felt(std::nullopt, true);
    result.contact->face = face;
    result.contact->held_s = stated_s = held_s;
    history.add(result, time_s);
  };
  // A slow window gets a view every two seconds of a contact of 210 s.
  for (int i = 0; i <= 5; ++i) add(PushedFace::kBack, 200 + 2 * i, 200.5 + 2 * i);
  ASSERT_EQ(history.contacts().size(), 1U);
  EXPECT_NEAR(history.contacts()[0].to_s - history.contacts()[0].from_s, stated_s, 1e-9);
  add(PushedFace::kUpper, 212, 1.5);
  ASSERT_EQ(history.contacts().size(), 2U);
  EXPECT_TRUE(history.contacts()[0].has_ended);
  EXPECT_EQ(history.contacts()[0].face, PushedFace::kBack);
  EXPECT_NEAR(history.contacts()[1].to_s - history.contacts()[1].from_s, 1.5, 1e-9);
}

TEST(TouchHistoryTest, RemembersThatAContactSlipped) {
  TouchHistory history;
  FrameResult slipping = felt(std::nullopt, true);
  slipping.contact->is_slipping = true;
  history.add(slipping, 1.0);
  history.add(felt(std::nullopt, true), 1.1);
  history.add(slipping, 1.15);
  history.add(slipping, 1.2);  // still the same slip
  history.add(felt(std::nullopt, true), 1.3);
  history.add(slipping, 1.5);
  history.add(felt(std::nullopt), 1.6);
  history.add(felt(std::nullopt, true), 1.7);
  ASSERT_EQ(history.contacts().size(), 2U);
  EXPECT_TRUE(history.has_slipped(history.contacts().front()));
  EXPECT_FALSE(history.has_slipped(history.contacts().back()));
  ASSERT_EQ(history.slips().size(), 3U);
  EXPECT_EQ(history.slips().back().from_s, 1.5);
}

TEST(ForceZeroTest, IsTheMeanOfTheLastHalfSecondOnly) {
  TouchHistory history;
  for (int i = 0; i < 100; ++i)
    history.add(felt(force_of(i < 50 ? 90 : i % 2, -1)), 0.02 * i + 0.001);
  const auto zero = present_zero(history);
  ASSERT_TRUE(zero);
  EXPECT_NEAR(zero->force_N.x(), 0.5, 0.03);
  EXPECT_NEAR(zero->force_N.y(), -1, 1e-12);
  EXPECT_FALSE(zero->has_contact);
  const Force now = zeroed(force_of(3, 1), zero);
  EXPECT_NEAR(now.force_N.x(), 2.5, 0.03);
  EXPECT_NEAR(now.force_N.y(), 2, 1e-12);
}

TEST(ForceZeroTest, IsNoneOutOfRangeOrWithoutReadings) {
  TouchHistory history;
  EXPECT_FALSE(present_zero(history));
  history.add(felt(std::nullopt), 1.0);
  EXPECT_FALSE(present_zero(history));
  Force unsure = force_of(1, 1);
  unsure.in_range = false;
  history.add(felt(unsure), 1.1);
  EXPECT_FALSE(present_zero(history));
  for (int i = 0; i < 30; ++i) history.add(felt(force_of(1, 1), true), 1.2 + 0.05 * i);
  const auto zero = present_zero(history);
  ASSERT_TRUE(zero);
  EXPECT_TRUE(zero->has_contact);
}

/// Readings that err by what they say, by a part that both share and one of their own.
double covered(double shared) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  int held = 0;
  constexpr int kCases = 20'000;
  for (int i = 0; i < kCases; ++i) {
    const double both = noise(random);
    const auto reading = [&](double truth) {
      Force force = force_of(
          truth + 0.1 * (std::sqrt(shared) * both + std::sqrt(1 - shared) * noise(random)), 0);
      return force;
    };
    TouchHistory history;
    history.add(felt(reading(0)), 1.0);
    const Force now = zeroed(reading(2.0), present_zero(history));
    held += std::abs(now.force_N.x() - 2.0) <= now.half_95_N.x();
  }
  return static_cast<double>(held) / kCases;
}

TEST(ForceZeroTest, IntervalsHoldWhateverBothReadingsShare) {
  EXPECT_NEAR(covered(0.0), 0.95, 0.006);
  EXPECT_GT(covered(0.5), 0.98);
  EXPECT_GT(covered(0.95), 0.999);
}

}  // namespace
}  // namespace alltact::test
