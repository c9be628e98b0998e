#include "core/gripper/gripper.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

/// The crank's angle by halving the loop equation |N - C|^2 = r^2 in long double, without the
/// closed form: from the line to the nut on, the distance of pin and nut only grows.
std::optional<long double> bisected(const Linkage& linkage, long double turns) {
  const LinkageParameters& p = linkage.parameters();
  const long double x = static_cast<long double>(p.nut_mm.x()) - p.pivot_mm.x();
  const long double z = static_cast<long double>(p.nut_mm.y()) - p.pivot_mm.y() +
                        static_cast<long double>(linkage.lead_mm()) * turns;
  const long double c = p.crank_mm, r = p.rod_mm, line = std::atan2(x, z);
  const long double way = p.assembly == AssemblyMode::kAhead ? std::numbers::pi_v<long double>
                                                             : -std::numbers::pi_v<long double>;
  const auto open = [&](long double part) {
    const long double t = line + part * way;
    const long double across = x - c * std::sin(t), along = z - c * std::cos(t);
    return across * across + along * along - r * r;
  };
  long double low = 0, high = 1;
  if (open(low) > 0 || open(high) < 0) return std::nullopt;
  for (int i = 0; i < 80; ++i) {
    const long double middle = (low + high) / 2;
    (open(middle) < 0 ? low : high) = middle;
  }
  return line + (low + high) / 2 * way;
}

long double turned(long double a, long double b) {
  return std::remainder(a - b, 2 * std::numbers::pi_v<long double>);
}

class LinkageDraw {
 public:
  explicit LinkageDraw(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  /// Any mechanism that closes somewhere: long rods and short ones, screws that run either way.
  Linkage linkage() {
    for (;;) {
      LinkageParameters p;
      p.pivot_mm = {between(-60, 60), between(-60, 60)};
      p.nut_mm = {between(-30, 30), between(-60, 60)};
      p.crank_mm = between(5, 60), p.rod_mm = between(5, 60);
      p.assembly = between(0, 1) < 0.5 ? AssemblyMode::kAhead : AssemblyMode::kBehind;
      const double lead = between(0.5, 5) * (between(0, 1) < 0.5 ? -1 : 1);
      if (auto made = Linkage::create(p, lead)) return *made;
    }
  }
  /// A motor position at a part of the way between two dead points.
  static double within(const MotorReach& reach, double part) {
    return reach.first.motor_turns + part * (reach.last.motor_turns - reach.first.motor_turns);
  }

 private:
  std::mt19937 random_;
};

TEST(Linkage, TheClosedFormIsTheLoopEquationHalved) {
  LinkageDraw draw(1);
  long double worst = 0;
  for (int run = 0; run < 10000; ++run) {
    const Linkage linkage = draw.linkage();
    const double m =
        LinkageDraw::within(linkage.reach_around(draw.between(-100, 100)), draw.between(0, 1));
    const auto angle = linkage.angle_at(m);
    ASSERT_TRUE(angle) << angle.error().sentence();
    const auto truth = bisected(linkage, m);
    ASSERT_TRUE(truth);
    worst = std::max(worst, std::abs(turned(angle->rad, *truth)));
    EXPECT_LE(std::abs(angle->rad), std::numbers::pi);
  }
  std::printf("[ figures  ] closed form against bisection: worst of 10000 %.2Lg rad\n", worst);
  EXPECT_LT(worst, 1e-9L);
}

TEST(Linkage, TheClosedFormHoldsUpToItsDeadPoints) {
  // What nut, lengths and their sums are rounded by, eight times half a last digit of 256 mm, moves
  // the angle by so much times its rate; no more is lost.
  LinkageDraw draw(2);
  double worst = 0;
  for (int run = 0; run < 10000; ++run) {
    const Linkage linkage = draw.linkage();
    const MotorReach reach = linkage.reach_around(draw.between(-100, 100));
    const double away = std::pow(10.0, draw.between(-12, -4));
    const double m = LinkageDraw::within(reach, draw.between(0, 1) < 0.5 ? away : 1 - away);
    const auto angle = linkage.angle_at(m);
    const auto truth = bisected(linkage, m);
    if (!angle || !truth) continue;  // the dead point itself is rounded, too
    const double rounding_turns = 8 * 2.8e-14 / std::abs(linkage.lead_mm());
    const double bound = 1e-12 + rounding_turns * std::abs(angle->rad_per_turn);
    const auto error = static_cast<double>(std::abs(turned(angle->rad, *truth)));
    worst = std::max(worst, error / bound);
    EXPECT_LT(error, bound);
  }
  std::printf("[ figures  ] near dead points: worst of what rounding allows %.2g\n", worst);
}

TEST(Linkage, TheDerivativeIsTheAnglesChange) {
  LinkageDraw draw(3);
  double worst = 0;
  for (int run = 0; run < 10000; ++run) {
    const Linkage linkage = draw.linkage();
    const MotorReach reach = linkage.reach_around(draw.between(-100, 100));
    const long double m = LinkageDraw::within(reach, draw.between(0.02, 0.98));
    const long double range = reach.last.motor_turns - reach.first.motor_turns, h = 1e-6L * range;
    const auto before = bisected(linkage, m - h), after = bisected(linkage, m + h);
    ASSERT_TRUE(before && after);
    const auto slope = static_cast<double>(turned(*after, *before) / (2 * h));
    const auto angle = linkage.angle_at(static_cast<double>(m));
    ASSERT_TRUE(angle);
    const double scale = std::abs(slope) + 1 / static_cast<double>(range);
    worst = std::max(worst, std::abs(angle->rad_per_turn - slope) / scale);
  }
  std::printf("[ figures  ] derivative against differences: worst of 10000 %.2g\n", worst);
  EXPECT_LT(worst, 1e-6);
}

TEST(Linkage, DeadPointsOfATextbooksSliderCrank) {
  // Central, crank 20, rod 50: dead at 70 and 30 mm on both sides, and the rod never lies across.
  LinkageParameters p;
  p.crank_mm = 20, p.rod_mm = 50;
  const auto plain = Linkage::create(p, 2.0)->dead_points();
  ASSERT_EQ(plain.size(), 4U);
  const double places[] = {-35, -15, 15, 35};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(plain[i].motor_turns, places[i], 1e-12);
  EXPECT_EQ(plain[0].kind, DeadPointKind::kStretched);
  EXPECT_EQ(plain[1].kind, DeadPointKind::kFolded);
  // A crank longer than the rod: across where c^2 = r^2 + h^2, 30-40-50.
  p.crank_mm = 50, p.rod_mm = 40;
  const auto across = Linkage::create(p, 1.0)->dead_points();
  ASSERT_EQ(across.size(), 6U);
  for (const DeadPoint& point : across)
    if (point.kind == DeadPointKind::kAcross) {
      EXPECT_NEAR(std::abs(point.motor_turns), 30, 1e-12);
    }
  // Offset by 30 with r - c = 10 < 30: it closes all the way between both stretched ends.
  p.nut_mm.x() = 30, p.crank_mm = 20, p.rod_mm = 30;
  const MotorReach reach = Linkage::create(p, 1.0)->reach_around(0);
  EXPECT_NEAR(reach.first.motor_turns, -40, 1e-12);
  EXPECT_NEAR(reach.last.motor_turns, 40, 1e-12);
}

TEST(Linkage, BetweenDeadPointsTheFingerTurnsOneWayAndAcrossThemTheOther) {
  LinkageDraw draw(4);
  int turns_back = 0;
  for (int run = 0; run < 150; ++run) {
    const Linkage linkage = draw.linkage();
    const MotorReach reach = linkage.reach_around(draw.between(-100, 100));
    std::vector<double> told;
    for (const DeadPoint& point : linkage.dead_points())
      if (point.kind == DeadPointKind::kAcross && point.motor_turns > reach.first.motor_turns &&
          point.motor_turns < reach.last.motor_turns)
        told.push_back(point.motor_turns);
    // Where the halved loop equation turns back, by steps.
    constexpr int kSteps = 400;
    std::vector<double> found;
    long double last = 0, last_step = 0;
    for (int i = 1; i < kSteps; ++i) {
      const double m = LinkageDraw::within(reach, static_cast<double>(i) / kSteps);
      const long double t = bisected(linkage, m).value_or(last);
      const long double step = i > 1 ? turned(t, last) : 0;
      if (step * last_step < 0)
        found.push_back(LinkageDraw::within(reach, static_cast<double>(i - 1) / kSteps));
      last = t;
      if (step != 0) last_step = step;
    }
    const double step = (reach.last.motor_turns - reach.first.motor_turns) / kSteps;
    // One nearer to an end than the steps see is not asked for.
    std::erase_if(told, [&](double m) {
      return m < reach.first.motor_turns + 3 * step || m > reach.last.motor_turns - 3 * step;
    });
    std::erase_if(found, [&](double m) {
      return m < reach.first.motor_turns + 3 * step || m > reach.last.motor_turns - 3 * step;
    });
    ASSERT_EQ(told.size(), found.size()) << run;
    for (std::size_t i = 0; i < told.size(); ++i) {
      EXPECT_NEAR(told[i], found[i], 2 * step);
      EXPECT_NEAR(linkage.angle_at(told[i])->rad_per_turn, 0, 1e-9);
      ++turns_back;
    }
  }
  EXPECT_GT(turns_back, 15) << "too few to say anything";
}

TEST(Linkage, AtAndBeyondItsEndsItSaysSo) {
  LinkageDraw draw(5);
  for (int run = 0; run < 2000; ++run) {
    const Linkage linkage = draw.linkage();
    const MotorReach reach = linkage.reach_around(draw.between(-100, 100));
    for (const double sign : {-1.0, 1.0}) {
      const DeadPoint& end = sign < 0 ? reach.first : reach.last;
      const double range = reach.last.motor_turns - reach.first.motor_turns;
      const auto near = linkage.angle_at(end.motor_turns - sign * 1e-10 * range);
      ASSERT_TRUE(near) << near.error().sentence();
      // dt/dm grows as the inverse root of the way that is left.
      const auto nearer = linkage.angle_at(end.motor_turns - sign * 1e-6 * range);
      const auto far = linkage.angle_at(end.motor_turns - sign * 1e-4 * range);
      ASSERT_TRUE(nearer && far);
      if (range > 1 && std::abs(far->rad_per_turn) * range > 10) {
        EXPECT_NEAR(std::abs(nearer->rad_per_turn / far->rad_per_turn), 10, 2);
      }
      const auto beyond = linkage.angle_at(end.motor_turns + sign * 1e-4 * range);
      if (beyond) continue;  // the other way begins there at once
      EXPECT_THAT(beyond.error().sentence(), HasSubstr("rod and crank do not meet at "));
      EXPECT_THAT(beyond.error().sentence(), HasSubstr("into one line"));
    }
  }
  LinkageParameters p;
  p.crank_mm = 20, p.rod_mm = 50;
  const auto linkage = Linkage::create(p, 2.0);
  EXPECT_EQ(linkage->angle_at(40).error().sentence(),
            "rod and crank do not meet at 40 turns: they do from 15 (rod and crank are folded into "
            "one line) to 35 (rod and crank are stretched into one line). Try: a motor position "
            "between these.");
  EXPECT_THAT(linkage->angle_at(std::nan("")).error().sentence(), HasSubstr("not a number"));
  const auto at_the_end = linkage->angle_at(35);
  ASSERT_TRUE(at_the_end);
  EXPECT_TRUE(std::isinf(at_the_end->rad_per_turn));
  p.rod_mm = 20;
  EXPECT_THAT(Linkage::create(p, 2.0)->angle_at(0).error().sentence(),
              HasSubstr("the finger may stand anywhere"));
}

TEST(Linkage, PartsThatFitNothingAreRefusedByTheirKey) {
  const auto refused = [](auto change, double lead = 2.0) {
    LinkageParameters p;
    p.crank_mm = 20, p.rod_mm = 50;
    change(p);
    const auto linkage = Linkage::create(p, lead);
    return linkage ? std::string() : linkage.error().where.english();
  };
  const double nan = std::nan("");
  EXPECT_EQ(refused([](auto&) {}), "");
  EXPECT_EQ(refused([](auto&) {}, 0.0), "lead_mm");
  EXPECT_EQ(refused([](auto&) {}, nan), "lead_mm");
  EXPECT_EQ(refused([](auto& p) { p.crank_mm = 0; }), "crank_mm");
  EXPECT_EQ(refused([](auto& p) { p.crank_mm = -1; }), "crank_mm");
  EXPECT_EQ(refused([&](auto& p) { p.rod_mm = nan; }), "rod_mm");
  EXPECT_EQ(refused([](auto& p) { p.rod_mm = 1e9; }), "rod_mm");
  EXPECT_EQ(refused([&](auto& p) { p.nut_mm.y() = nan; }), "nut_mm");
  EXPECT_EQ(refused([](auto& p) { p.pivot_mm.x() = 1e5; }), "pivot_mm");
  EXPECT_EQ(refused([](auto& p) { p.nut_mm.x() = 70; }), "rod_mm");
}

}  // namespace
}  // namespace alltact
