// One line of a gauge, and its unit.
#include "core/devices/gauge_source.h"

#include <random>

#include <gtest/gtest.h>

namespace alltact {
namespace {

using LineKind = GaugeLine::Kind;

GaugeLine told(const char* line, const GaugeLineRules& rules = {}) {
  return read_gauge_line(line, rules);
}

void expect_newtons(const char* line, double force_N, double digit_N) {
  const GaugeLine read = told(line);
  ASSERT_EQ(read.kind, LineKind::kValues) << line;
  ASSERT_EQ(read.count, 1) << line;
  EXPECT_NEAR(read.force_N[0], force_N, 1e-12 * std::max(1.0, std::abs(force_N))) << line;
  EXPECT_NEAR(read.digit_N[0], digit_N, 1e-12) << line;
}

// NIST SP 811, appendix B: 1 kgf = 9.80665 N, 1 lbf = 4.4482216152605 N, 1 ozf = 0.27801385095 N.
TEST(ForceUnit, CountsInNewtons) {
  EXPECT_EQ(newtons_in("N"), 1.0);
  EXPECT_EQ(newtons_in("mN"), 1e-3);
  EXPECT_EQ(newtons_in("KN"), 1e3);
  EXPECT_DOUBLE_EQ(*newtons_in("kgf"), 9.80665);
  EXPECT_DOUBLE_EQ(*newtons_in("g"), 9.80665e-3);
  EXPECT_NEAR(*newtons_in("lbF"), 4.4482216152605, 1e-13);
  EXPECT_NEAR(*newtons_in("ozF"), 0.27801385095, 1e-11);
  for (const char* none : {"", "Nm", "s", "mm", "lbs-ft", "kPa"}) EXPECT_FALSE(newtons_in(none));
}

TEST(GaugeLine, UnitsAreConverted) {
  expect_newtons("+0.123 N", 0.123, 1e-3);
  expect_newtons("-18.78 lbF", -18.78 * 4.4482216152605, 0.01 * 4.4482216152605);
  expect_newtons("4.285 N", 4.285, 1e-3);
  expect_newtons("12N", 12, 1);
  expect_newtons("250 g", 2.4516625, 9.80665e-3);
  expect_newtons("-.5 kgf", -4.903325, 0.980665);
  GaugeLineRules grams;
  grams.unit_N = *newtons_in("g");
  EXPECT_NEAR(told("100", grams).force_N[0], 0.980665, 1e-12);
  EXPECT_NEAR(told("100 N", grams).force_N[0], 100, 1e-12) << "what the line says counts";
}

TEST(GaugeLine, ImadaTellsUnitModeAndJudgement) {
  expect_newtons("+01.23KT0", 1.23 * 9.80665, 0.0980665);
  expect_newtons("-12.34NTO", -12.34, 0.01);
  expect_newtons("+0.50OPL", 0.5 * 4.4482216152605, 0.044482216152605);
  EXPECT_EQ(told("+99.99NTE").kind, LineKind::kOverRange);
  EXPECT_EQ(told("+99.99XTO").kind, LineKind::kNoise);
}

TEST(GaugeLine, SauterTellsItsSignByADigit) {
  GaugeLineRules rules;
  rules.format = GaugeFormat::kSauter;
  EXPECT_DOUBLE_EQ(told("0011.70", rules).force_N[0], -11.70);
  EXPECT_DOUBLE_EQ(told("1021.15", rules).force_N[0], 21.15);
  EXPECT_DOUBLE_EQ(told("0000.00", rules).force_N[0], 0);
  EXPECT_FALSE(std::signbit(told("0000.00", rules).force_N[0]));
  for (const char* bad : {"2011.70", "-11.70", "0-1.70", "01", "0011.7x", "0011..70"})
    EXPECT_EQ(told(bad, rules).kind, LineKind::kNoise) << bad;
}

TEST(GaugeLine, SeveralValuesStandSideBySide) {
  const GaugeLine three = told("1.2 0.3\t-0.1 kgf");
  ASSERT_EQ(three.count, 3);
  EXPECT_NEAR(three.force_N[2], -0.980665, 1e-12) << "one unit for all";
  EXPECT_NEAR(three.force_N[0], 11.76798, 1e-12);
  const GaugeLine mixed = told("1 N,2 kgf");
  ASSERT_EQ(mixed.count, 2);
  EXPECT_EQ(mixed.force_N[0], 1);
  EXPECT_NEAR(mixed.force_N[1], 19.6133, 1e-12);
  EXPECT_EQ(told("1,25").count, 2);
  GaugeLineRules comma;
  comma.is_comma_decimal = true;
  EXPECT_EQ(told("1,25", comma).force_N[0], 1.25);
}

TEST(GaugeLine, OverRangeIsNoForceAndNoNoise) {
  for (const char* over : {"OL", "O.L.", "-OL-", "OVER", "Over N", "0L", "HELP", "ERR", "-----",
                           "++++++", "OL kgf", "OVERLOAD", "- - - -", ">>>>"})
    EXPECT_EQ(told(over).kind, LineKind::kOverRange) << over;
}

TEST(GaugeLine, NothingIsMadeOfBrokenLines) {
  for (const char* noise : {"",
                            " ",
                            "N",
                            "1.2.3",
                            "0.12+0.123 N",
                            "+-1",
                            "--1",
                            "1e5",
                            "1 2 3 4",
                            "12 mm",
                            "1 N N",
                            "abc",
                            "*10",
                            "1.2\x80N",
                            "nan",
                            "inf",
                            "1e400",
                            "0x10",
                            "1234567890123456 N",
                            "100001 N",
                            "900000 kN",
                            "Mark-10 M5",
                            ".",
                            "+",
                            "+.N",
                            "\x1b[2J"})
    EXPECT_EQ(told(noise).kind, LineKind::kNoise) << noise;
}

TEST(GaugeLine, AnyBytesAreALineOrNone) {
  std::mt19937 random(3);
  const std::string some = "+-0123456789.., NkgflbOTE\t-OVER\x7f";
  for (int round = 0; round < 20000; ++round) {
    std::string line;
    for (std::size_t i = 0; i < random() % 14; ++i) line += some[random() % some.size()];
    const GaugeLine read = read_gauge_line(line, {});
    if (read.kind != LineKind::kValues) continue;
    ASSERT_GE(read.count, 1);
    ASSERT_LE(read.count, 3);
    for (std::size_t i = 0; i < static_cast<std::size_t>(read.count); ++i)
      EXPECT_LE(std::abs(read.force_N[i]), 1e5) << line;
  }
}

TEST(GaugeDirections, PointWhereTheyAreTold) {
  const auto x = GaugeDirections::parse("-y");
  ASSERT_TRUE(x);
  EXPECT_EQ(x->count, 1);
  EXPECT_EQ(x->force_N(told("2 N")), Eigen::Vector3d(0, -2, 0));
  const auto slanted = GaugeDirections::parse("3,4,0");
  ASSERT_TRUE(slanted);
  EXPECT_TRUE(slanted->force_N(told("5 N")).isApprox(Eigen::Vector3d(3, 4, 0), 1e-12));
  const auto two = GaugeDirections::parse("y/-x");
  ASSERT_TRUE(two);
  EXPECT_EQ(two->count, 2);
  EXPECT_EQ(two->force_N(told("1 2")), Eigen::Vector3d(-2, 1, 0));
  EXPECT_EQ(GaugeDirections().force_N(told("1 2 3")), Eigen::Vector3d(1, 2, 3));
  for (const char* bad : {"", "w", "0,0,0", "1,2", "x/", "x/y/z/x", "1,2,nan"})
    EXPECT_FALSE(GaugeDirections::parse(bad)) << bad;
}

TEST(GaugeSample, KnowsWhatRoundingCosts) {
  const GaugeSample sample = sample_of(told("1.25 N"), {}, 7);
  EXPECT_EQ(sample.time_s, 7);
  EXPECT_TRUE(sample.has_force);
  EXPECT_NEAR(sample.sd_N, 0.01 / std::sqrt(12.0), 1e-15);
}

}  // namespace
}  // namespace alltact
