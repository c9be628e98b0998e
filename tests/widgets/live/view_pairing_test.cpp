// Views of two cameras, joined by when they were taken.
#include "widgets/live/live_pair.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

constexpr double kFrame_ms = 1000.0 / 30;

std::shared_ptr<const LiveView> view_at(std::uint64_t number, double time_ms) {
  auto frame = std::make_shared<Frame>();
  frame->sequence = number;
  frame->time_ns = std::llround(1e6 * time_ms);
  auto view = std::make_shared<LiveView>();
  view->result.frame = frame;
  return view;
}

double time_ms(const std::shared_ptr<const LiveView>& view) {
  return 1e-6 * static_cast<double>(*view->result.frame->time_ns);
}

std::optional<ViewPair> added(ViewPairing& pairing, std::size_t which, std::uint64_t number,
                              double at_ms) {
  return pairing.add(which, view_at(number, at_ms), std::llround(1e6 * at_ms));
}

/// Views as they come from measuring: each some time after it was taken.
struct Arrival {
  std::size_t which;
  std::uint64_t number;
  double taken_ms, came_ms;
};

std::vector<Arrival> arrivals(double second_later_ms, double second_period_ms, double lost) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> late(5, 25), part(0, 1);
  std::vector<Arrival> all;
  for (const std::size_t which : {0U, 1U}) {
    const double period = which == 0 ? kFrame_ms : second_period_ms;
    double came = 0;
    for (std::uint64_t i = 0; static_cast<double>(i) * period < 10'000; ++i) {
      const double taken =
          1000 + (which == 1 ? second_later_ms : 0) + static_cast<double>(i) * period;
      came = std::max(came, taken + late(random));
      if (part(random) >= lost) all.push_back({which, i, taken, came});
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Arrival& a, const Arrival& b) { return a.came_ms < b.came_ms; });
  return all;
}

struct PairRun {
  int pairs = 0;
  double most_apart_ms = 0;
};
PairRun run(double second_later_ms, double second_period_ms, double lost) {
  ViewPairing pairing;
  PairRun run;
  std::array<double, 2> last{};
  for (const Arrival& a : arrivals(second_later_ms, second_period_ms, lost)) {
    const auto pair = added(pairing, a.which, a.number, a.taken_ms);
    if (!pair) continue;
    ++run.pairs;
    EXPECT_TRUE(pair->is_in_time);
    const double first = time_ms(pair->views[0]), second = time_ms(pair->views[1]);
    EXPECT_NEAR(*pair->later_ms, second - first, 1e-6);
    EXPECT_GE(first, last[0]) << "time goes back";
    EXPECT_GE(second, last[1]) << "time goes back";
    last = {first, second};
    run.most_apart_ms = std::max(run.most_apart_ms, std::abs(second - first));
  }
  return run;
}

TEST(ViewPairingTest, PairsFreeRunningCamerasWithinHalfAFrame) {
  for (const double later_ms : {0.0, 3.0, -7.0, 16.0}) {
    const PairRun seen = run(later_ms, kFrame_ms, 0);
    EXPECT_LE(seen.most_apart_ms, 0.5 * kFrame_ms + 1e-6) << later_ms;
    EXPECT_GE(seen.pairs, 290) << later_ms;
  }
}

TEST(ViewPairingTest, PairsCamerasOfOtherRatesAndWithLostFrames) {
  const PairRun drifting = run(2, 1.01 * kFrame_ms, 0);
  EXPECT_LE(drifting.most_apart_ms, 0.5 * 1.01 * kFrame_ms + 1e-6);
  EXPECT_GE(drifting.pairs, 280);
  const PairRun fast = run(2, 0.5 * kFrame_ms, 0);
  EXPECT_LE(fast.most_apart_ms, 0.5 * kFrame_ms + 1e-6);
  const PairRun lossy = run(5, kFrame_ms, 0.2);
  EXPECT_LE(lossy.most_apart_ms, 0.5 * kFrame_ms + 1e-6);
  EXPECT_GE(lossy.pairs, 170);  // 0.8 * 0.8 of 300 have a partner
}

TEST(ViewPairingTest, TakesTheNearerPartnerOnceItIsThere) {
  ViewPairing pairing;
  EXPECT_FALSE(added(pairing, 0, 0, 0));
  EXPECT_FALSE(added(pairing, 1, 0, -14));  // no period is known yet
  const auto first = added(pairing, 0, 1, kFrame_ms);
  EXPECT_FALSE(first) << "47 ms apart";
  const auto later = added(pairing, 1, 1, kFrame_ms - 14);
  ASSERT_TRUE(later);
  EXPECT_NEAR(*later->later_ms, -14, 1e-5);
}

TEST(ViewPairingTest, SaysAfterAWhileThatNothingIsInTime) {
  ViewPairing pairing;
  int in_time = 0, others = 0;
  double first_other_ms = 0;
  for (std::uint64_t i = 0; i < 90; ++i) {
    const double at = 1000 + static_cast<double>(i) * kFrame_ms;
    // The second camera stands still after a second.
    for (const std::size_t which : {0U, 1U}) {
      if (which == 1 && i > 30) continue;
      const auto pair = added(pairing, which, i, at);
      if (!pair) continue;
      ++(pair->is_in_time ? in_time : others);
      if (!pair->is_in_time && first_other_ms == 0) first_other_ms = at;
      EXPECT_LT(*pair->later_ms, pair->is_in_time ? 1.0 : -999.9);
    }
  }
  EXPECT_GE(in_time, 29);
  EXPECT_GT(others, 20);
  EXPECT_GE(first_other_ms, 1000 + 30 * kFrame_ms + 1000);
}

TEST(ViewPairingTest, WithoutTimesTheNewestStandTogether) {
  ViewPairing pairing;
  EXPECT_FALSE(pairing.add(0, view_at(0, 0), std::nullopt));
  const auto pair = pairing.add(1, view_at(5, 0), std::nullopt);
  ASSERT_TRUE(pair);
  EXPECT_FALSE(pair->later_ms);
  EXPECT_EQ(pair->views[1]->result.frame->sequence, 5U);
}

TEST(ViewPairingTest, BeginsAnewWithAnotherSource) {
  ViewPairing pairing;
  for (std::uint64_t i = 0; i < 20; ++i)
    for (const std::size_t which : {0U, 1U})
      static_cast<void>(added(pairing, which, i, 5000 + static_cast<double>(i) * kFrame_ms));
  int pairs = 0;
  for (std::uint64_t i = 0; i < 20; ++i)
    for (const std::size_t which : {0U, 1U})
      if (const auto pair = added(pairing, which, i, 100 + static_cast<double>(i) * kFrame_ms)) {
        ++pairs;
        EXPECT_TRUE(pair->is_in_time);
        EXPECT_LT(time_ms(pair->views[0]), 1000);
      }
  EXPECT_GE(pairs, 18);
}

}  // namespace
}  // namespace alltact::test
