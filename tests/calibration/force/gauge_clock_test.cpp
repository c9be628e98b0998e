// How late a gauge is, told by the markers of fingers whose delay is known.
#include "calibration/force/collect_force.h"

#include <random>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

/// Presses by hand at times drawn at random: forces in two directions that rise and fall within
/// 0.2 to 0.8 s, over a slow drift.
class DrawnPresses {
 public:
  DrawnPresses(std::uint64_t seed, double seconds) : random_(seed) {
    for (double at = 1; at < seconds; at += between(0.6, 2.5))
      presses_.push_back({at, between(0.1, 0.4), between(0.5, 3), between(-1.5, 1.5)});
  }
  [[nodiscard]] Eigen::Vector2d force_N(double time_s) const {
    Eigen::Vector2d force(0.05 * std::sin(0.1 * time_s), 0);
    for (const Press& press : presses_) {
      const double part = (time_s - press.at_s) / press.width_s;
      if (std::abs(part) < 4)
        force += std::exp(-0.5 * part * part) * Eigen::Vector2d(press.x_N, press.y_N);
    }
    return force;
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  struct Press {
    double at_s, width_s, x_N, y_N;
  };
  std::mt19937_64 random_;
  std::vector<Press> presses_;
};

/// Frames at 30 Hz from `first_s` on, six markers that move with the force, with noise, creep and a
/// marker that is hidden now and then.
std::vector<MarkerFrame> frames_of(const DrawnPresses& presses, double first_s, double seconds,
                                   double noise_px, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise_px);
  std::vector<MarkerFrame> frames;
  double crept = 0;
  for (int i = 0; i < static_cast<int>(30 * seconds); ++i) {
    const double time_s = i / 30.0;
    const Eigen::Vector2d force = presses.force_N(time_s);
    crept += 0.002 * (force.x() - crept);
    MarkerFrame frame;
    frame.name = fmt::format("frame_{:05}", i);
    frame.time_s = first_s + time_s;
    for (int m = 0; m < 6; ++m)
      frame.markers.push_back({100.0 * m + (3 + m) * (force.x() + 0.3 * crept) + normal(random),
                               50.0 + 2 * force.y() - m * force.x() + normal(random), m != i % 97,
                               0.1});
    frames.push_back(std::move(frame));
  }
  return frames;
}

struct GaugeWorld {
  double rate_Hz = 40, delay_s = 0, noise_N = 0.02, seconds = 40;
  double clock_first_s = 500;  ///< gauge's time at the frames' first
  double drift = 0;
  bool is_on_frame_clock = true;
};

ForceGauge gauge_of(const DrawnPresses& presses, const GaugeWorld& world, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, world.noise_N);
  ForceGauge gauge;
  gauge.by_time = true, gauge.is_on_frame_clock = world.is_on_frame_clock;
  for (int i = 0; i < static_cast<int>(world.rate_Hz * world.seconds); ++i) {
    const double true_s = i / world.rate_Hz;
    GaugeReading reading;
    reading.time_s = world.clock_first_s + world.delay_s + true_s * (1 + world.drift);
    reading.force_N.head<2>() = presses.force_N(true_s);
    reading.force_N.head<2>() += Eigen::Vector2d(normal(random), normal(random));
    gauge.readings.push_back(reading);
  }
  return gauge;
}

GaugeClock settled(const std::vector<MarkerFrame>& frames, const ForceGauge& gauge,
                   std::vector<Message>& remarks, const CollectOptions& options = {}) {
  remarks.clear();
  return estimate_gauge_clock(frames, gauge, options, remarks);
}

TEST(GaugeClock, DelaysOfDrawnFingersAreFoundWithinTheirSd) {
  double squares = 0;
  constexpr int kWorlds = 20;
  for (int world = 0; world < kWorlds; ++world) {
    DrawnPresses presses(100 + static_cast<std::uint64_t>(world), 40);
    GaugeWorld how;
    how.delay_s = presses.between(-0.1, 0.45);
    how.rate_Hz = presses.between(15, 100);
    const auto frames = frames_of(presses, 500, 40, presses.between(0.05, 0.5), 7);
    std::vector<Message> remarks;
    const GaugeClock clock = settled(frames, gauge_of(presses, how, 8), remarks);
    ASSERT_EQ(clock.source, GaugeClock::Source::kMotion) << world;
    EXPECT_NEAR(clock.shift_s, how.delay_s, 0.005) << world;
    EXPECT_LT(clock.sd_s, 0.01) << world;
    EXPECT_GT(clock.r2, 0.8) << world;
    squares += std::pow((clock.shift_s - how.delay_s) / std::max(clock.sd_s, 5e-4), 2);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].english().find(how.delay_s > 0 ? "later than the" : "earlier than the"),
              std::string::npos)
        << remarks[0].english();
  }
  EXPECT_LT(std::sqrt(squares / kWorlds), 2.5) << "errors are as large as their sd tells";
}

TEST(GaugeClock, OtherClocksAreMatchedWithTheirDrift) {
  for (const double drift : {0.0, 150e-6, -400e-6}) {
    DrawnPresses presses(31, 240);
    GaugeWorld how;
    how.seconds = 240, how.clock_first_s = 3, how.delay_s = 0.2, how.drift = drift;
    how.is_on_frame_clock = false;
    // The gauge began 5 s before the frames and ended 5 s before them.
    ForceGauge gauge = gauge_of(presses, how, 4);
    auto frames = frames_of(presses, 81234.5, 240, 0.1, 5);
    frames.erase(frames.begin(), frames.begin() + 150);
    gauge.readings.resize(gauge.readings.size() - 200);
    std::vector<Message> remarks;
    const GaugeClock clock = settled(frames, gauge, remarks);
    ASSERT_EQ(clock.source, GaugeClock::Source::kMotion) << drift;
    EXPECT_NEAR(clock.drift, drift, 30e-6);
    // At both ends and in the middle the gauge's time is what it was.
    for (const double true_s : {10.0, 120.0, 230.0})
      EXPECT_NEAR(clock.gauge_time_s(81234.5 + true_s), 3.2 + true_s * (1 + drift), 0.01) << drift;
    EXPECT_NEAR(clock.frame_time_s(clock.gauge_time_s(81300)), 81300, 1e-6);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].english().find("different clocks"), std::string::npos);
  }
}

TEST(GaugeClock, WhatTheMotionDoesNotTellIsAssumedAndSaid) {
  DrawnPresses presses(41, 40), others(42, 40);
  std::vector<Message> remarks;
  // Forces that have nothing to do with the motion.
  EXPECT_EQ(settled(frames_of(presses, 500, 40, 0.1, 1), gauge_of(others, {}, 2), remarks).source,
            GaugeClock::Source::kAssumed);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_NE(remarks[0].english().find("could not be estimated"), std::string::npos);
  // One that never moves.
  auto still = frames_of(presses, 500, 40, 0, 1);
  for (MarkerFrame& frame : still) frame.markers = still.front().markers;
  EXPECT_EQ(settled(still, gauge_of(presses, {}, 2), remarks).shift_s, 0);
  // Presses like a clock's: any of several shifts would do.
  std::vector<MarkerFrame> periodic = frames_of(presses, 500, 40, 0.1, 1);
  ForceGauge beats = gauge_of(presses, {}, 2);
  const auto beat = [](double time_s) { return 2 * std::sin(2 * M_PI * time_s / 0.5); };
  for (MarkerFrame& frame : periodic)
    for (Marker& marker : frame.markers) marker.u = 100 + 5 * beat(*frame.time_s), marker.v = 50;
  for (GaugeReading& reading : beats.readings) reading.force_N << beat(reading.time_s), 0, 0;
  EXPECT_EQ(settled(periodic, beats, remarks).source, GaugeClock::Source::kAssumed);
  // Nothing at all.
  EXPECT_EQ(settled({}, beats, remarks).shift_s, 0);
}

TEST(GaugeClock, WhatIsGivenIsTaken) {
  DrawnPresses presses(51, 40);
  std::vector<Message> remarks;
  CollectOptions options;
  options.shift_s = 0.123, options.drift = 1e-5;
  const GaugeClock clock =
      settled(frames_of(presses, 500, 40, 0.1, 1), gauge_of(presses, {}, 2), remarks, options);
  EXPECT_EQ(clock.source, GaugeClock::Source::kGiven);
  EXPECT_NEAR(clock.gauge_time_s(510), 510.123 + 1e-4, 1e-9);
  EXPECT_TRUE(remarks.empty());
}

TEST(GaugeClock, ADelayThatIsTakenOutMakesTheTableRight) {
  DrawnPresses presses(61, 40);
  GaugeWorld how;
  how.delay_s = 0.25, how.noise_N = 0;
  const auto collected =
      collect_force(frames_of(presses, 500, 40, 0.05, 1), gauge_of(presses, how, 2));
  ASSERT_TRUE(collected) << collected.error().sentence();
  double squares = 0, late = 0;
  const ForceTable& table = collected->table;
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    const double time_s = table.time_s[row] - 500;
    squares +=
        (table.force_N.row(row).head<2>().transpose() - presses.force_N(time_s)).squaredNorm();
    late += (presses.force_N(time_s - 0.25) - presses.force_N(time_s)).squaredNorm();
  }
  EXPECT_LT(squares, 1e-3 * late) << "against the table of a gauge taken at its word";
  EXPECT_GT(table.block.size(), 0U);
  EXPECT_GE(std::set<std::string>(table.block.begin(), table.block.end()).size(), 5U)
      << "each press is a block";
}

/// Held at forces of which each is typed 1.5 s after the finger came to rest; in between it moves.
TEST(HeldReadings, CountForTheRestAroundTheirEnter) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0, 0.05);
  ForceGauge gauge;
  gauge.by_time = gauge.is_on_frame_clock = true;
  std::vector<MarkerFrame> frames;
  const auto level = [](int hold) { return 0.4 * hold + 0.1; };
  const auto true_N = [&](double time_s) {
    const int hold = static_cast<int>(time_s / 4);
    const double part = std::min(1.0, time_s - 4 * hold);  // of the way from the hold before
    return (1 - part) * (hold > 0 ? level(hold - 1) : 0) + part * level(hold);
  };
  for (int i = 0; i < 30 * 40; ++i) {  // 10 holds of 3 s with 1 s of motion before each
    const double time_s = i / 30.0;
    const double force = true_N(time_s);
    MarkerFrame frame;
    frame.name = fmt::format("frame_{:05}", i);
    frame.time_s = 100 + time_s;
    for (int m = 0; m < 4; ++m)
      frame.markers.push_back(
          {100.0 * m + 20 * force + normal(random), 50 + normal(random), true, 0.1});
    frames.push_back(std::move(frame));
  }
  for (int hold = 0; hold < 10; ++hold) {
    GaugeReading reading;
    reading.time_s = 100 + 4 * hold + 2.5;
    reading.holds = true;
    reading.force_N = Eigen::Vector3d(level(hold), hold % 2, 0);
    reading.block = fmt::format("typed {}", hold + 1);
    gauge.readings.push_back(reading);
  }
  gauge.has_block = true;
  const auto collected = collect_force(frames, gauge);
  ASSERT_TRUE(collected) << collected.error().sentence();
  EXPECT_TRUE(collected->remarks.empty());
  const ForceTable& table = collected->table;
  EXPECT_NEAR(static_cast<double>(table.rows()), 10 * 90, 45) << "the rests, and little of the way";
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    // Four times their noise are 0.4 px, or 0.02 N.
    EXPECT_NEAR(table.force_N(row, 0), true_N(table.time_s[row] - 100), 0.025);
    const int hold = static_cast<int>(std::lround((table.force_N(row, 0) - level(0)) / 0.4));
    EXPECT_EQ(table.block[static_cast<std::size_t>(row)], fmt::format("typed {}", hold + 1));
  }
  // An empty line ends a hold although the finger rests on.
  GaugeReading release;
  release.time_s = 100 + 4 * 9 + 3.0;
  release.has_force = false;
  gauge.readings.push_back(release);
  EXPECT_LT(collect_force(frames, gauge)->table.rows(), table.rows() - 25);
}

}  // namespace
}  // namespace alltact
