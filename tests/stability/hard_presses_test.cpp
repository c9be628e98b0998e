// Presses that say little, twice the same, or what is not true: calibrate() gives a mapping within
// a bound, or says by name what is wrong with them.
#include "calibration/joint/calibrate.h"
#include "tests/stability/awaited.h"
#include "tests/support/made_press.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;
using testing::HasSubstr;

constexpr float kInfinite = std::numeric_limits<float>::infinity();
const Layer kLayer{0.7, 0.02};

Press press_at(double u, double v, double depth_mm, std::mt19937& random, const std::string& name) {
  return make_press(flat_scene(), kLayer, {}, {{u, v, 4.0, depth_mm}}, 1.0, random, name).press;
}

/// Six at different places and depths.
std::vector<Press> good_presses(std::mt19937& random) {
  std::vector<Press> presses;
  for (int i = 0; i < 6; ++i)
    presses.push_back(press_at(120 + 30.0 * i, 100 + 40.0 * (i % 3), 0.35 + 0.14 * i, random,
                               fmt::format("p{}", i)));
  return presses;
}

Result<Calibration> solved(const std::vector<Press>& presses) {
  const MadeScene scene = flat_scene();
  return calibrate(presses, scene.camera, scene.face, {}, Job{});
}

/// Greatest error of the mapping up to where the deepest press went.
double mapping_error_mm(const Calibration& calibration) {
  const Mapping mapping = Mapping::create(calibration.mapping).value();
  double worst = 0;
  for (int i = 0; i <= 200; ++i) {
    const double x = mapping.x_max() * i / 200.0;
    worst = std::max(worst, std::abs(mapping.depth_mm(x) - kLayer.depth_at(x)));
  }
  return worst;
}

/// All that a calibration tells its user beside figures.
std::string reported(const Calibration& calibration) {
  return fmt::format("{} | {}", fmt::join(calibration.left_out, "; "),
                     fmt::join(calibration.remarks, "; "));
}

bool is_finite(const Calibration& c) {
  bool all = std::isfinite(c.residual_mm) && std::isfinite(c.held_out_mm) &&
             std::isfinite(c.spread_mm) && std::isfinite(c.condition);
  for (const double value : c.mapping.chebyshev) all = all && std::isfinite(value);
  for (const BallFit& ball : c.balls)
    all = all && ball.centre_mm.allFinite() && ball.centre_sd_mm.allFinite();
  return all && c.mapping.covariance.allFinite();
}

TEST(HardPresses, AllEquallyDeepGiveTheMapping) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(31);
  std::vector<Press> presses;
  for (int i = 0; i < 6; ++i)
    presses.push_back(
        press_at(110 + 35.0 * i, 110 + 40.0 * (i % 3), 0.8, random, fmt::format("p{}", i)));
  const auto calibration = solved(presses);
  ASSERT_TRUE(calibration.ok()) << calibration.error().sentence();
  EXPECT_LT(mapping_error_mm(*calibration), 0.03);
}

TEST(HardPresses, AllInOnePlaceGiveTheMapping) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(32);
  std::vector<Press> presses;
  for (int i = 0; i < 6; ++i)
    presses.push_back(press_at(200, 150, 0.35 + 0.14 * i, random, fmt::format("p{}", i)));
  const auto calibration = solved(presses);
  ASSERT_TRUE(calibration.ok()) << calibration.error().sentence();
  EXPECT_LT(mapping_error_mm(*calibration), 0.03);
}

TEST(HardPresses, ATenthOfAMillimetreDeepGiveTheMappingOrAReason) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(33);
  std::vector<Press> presses;
  for (int i = 0; i < 6; ++i)
    presses.push_back(
        press_at(110 + 35.0 * i, 110 + 40.0 * (i % 3), 0.1, random, fmt::format("p{}", i)));
  const auto calibration = solved(presses);
  if (!calibration.ok()) {
    EXPECT_THAT(calibration.error().sentence(),
                testing::AnyOf(HasSubstr("dark"), HasSubstr("deep")));
    return;
  }
  // A tenth of what they are deep.
  EXPECT_LT(mapping_error_mm(*calibration), 0.01) << reported(*calibration);
}

TEST(HardPresses, TheSameOneSixTimesIsToldAndProvesNothing) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(34);
  const Press one = press_at(200, 150, 0.9, random, "p0");
  std::vector<Press> presses(6, one);
  for (int i = 0; i < 6; ++i) presses[static_cast<std::size_t>(i)].name = fmt::format("p{}", i);
  const auto calibration = solved(presses);
  if (!calibration.ok()) {
    EXPECT_THAT(calibration.error().sentence(), HasSubstr("same"));
    return;
  }
  EXPECT_THAT(reported(*calibration), HasSubstr("same"));
}

TEST(HardPresses, OneTwiceAmongGoodOnesDoesNoHarm) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(35);
  std::vector<Press> presses = good_presses(random);
  presses.push_back(presses[2]);
  presses.back().name = "again";
  const auto calibration = solved(presses);
  ASSERT_TRUE(calibration.ok()) << calibration.error().sentence();
  EXPECT_LT(mapping_error_mm(*calibration), 0.03);
  EXPECT_TRUE(is_finite(*calibration));
}

TEST(HardPresses, OneOfTheWrongRadiusIsNamedOrDoesNoHarm) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(36);
  std::vector<Press> presses = good_presses(random);
  presses[3].ball_radius_mm = 5.0;  // it was 4.0
  const auto calibration = solved(presses);
  ASSERT_TRUE(calibration.ok()) << calibration.error().sentence();
  EXPECT_TRUE(is_finite(*calibration));
  if (mapping_error_mm(*calibration) >= 0.03) {
    EXPECT_THAT(reported(*calibration), HasSubstr("p3"));
  }
}

TEST(HardPresses, OnesOverTheEdgeGiveTheMappingAndAreMarkedAsCut) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(37);
  std::vector<Press> presses;
  for (int i = 0; i < 6; ++i)
    presses.push_back(press_at(i % 2 == 0 ? 4.0 : 395.0, 60 + 35.0 * i, 0.4 + 0.12 * i, random,
                               fmt::format("p{}", i)));
  const auto calibration = solved(presses);
  if (!calibration.ok()) {
    EXPECT_THAT(calibration.error().sentence(),
                testing::AnyOf(HasSubstr("rim"), HasSubstr("edge")));
    return;
  }
  EXPECT_LT(mapping_error_mm(*calibration), 0.03) << reported(*calibration);
  for (const BallFit& ball : calibration->balls) EXPECT_TRUE(ball.cut_by_edge) << ball.press;
}

TEST(HardPresses, ABallThatIsNearlyItsEquatorDeepIsNamedOrGivesTheMapping) {
  ALLTACT_SKIP_IF_AWAITED();
  std::mt19937 random(38);
  std::vector<Press> presses = good_presses(random);
  presses.push_back(
      make_press(flat_scene(), kLayer, {}, {{200, 150, 1.3, 1.25}}, 1.0, random, "equator").press);
  const auto calibration = solved(presses);
  ASSERT_TRUE(calibration.ok()) << calibration.error().sentence();
  if (mapping_error_mm(*calibration) >= 0.03) {
    EXPECT_THAT(reported(*calibration), HasSubstr("equator"));
  }
}

/// Two hundred pixels of each press, anywhere.
void expect_harmless(float bad) {
  std::mt19937 random(39);
  std::vector<Press> presses = good_presses(random);
  for (Press& press : presses)
    for (int i = 0; i < 200; ++i)
      press.difference.x.at<float>(static_cast<int>(random() % 300),
                                   static_cast<int>(random() % 400)) = bad;
  const auto calibration = solved(presses);
  ASSERT_TRUE(calibration.ok()) << bad << ": " << calibration.error().sentence();
  EXPECT_TRUE(is_finite(*calibration)) << bad;
  EXPECT_LT(mapping_error_mm(*calibration), 0.03) << bad;
}

TEST(HardPresses, PixelsThatAreNoNumbersDoNoHarm) {
  ALLTACT_SKIP_IF_AWAITED();
  expect_harmless(std::nanf(""));
}

TEST(HardPresses, PixelsThatAreInfiniteDoNoHarm) {
  ALLTACT_SKIP_IF_AWAITED();
  expect_harmless(kInfinite);
  expect_harmless(-kInfinite);
}

TEST(HardPresses, OneOfNothingButNoNumbersIsLeftOutByName) {
  ALLTACT_SKIP_IF_AWAITED();
  for (const float bad : {std::nanf(""), kInfinite, -kInfinite}) {
    std::mt19937 random(40);
    std::vector<Press> presses = good_presses(random);
    presses[1].difference.x.setTo(bad);
    const auto calibration = solved(presses);
    ASSERT_TRUE(calibration.ok()) << bad << ": " << calibration.error().sentence();
    EXPECT_THAT(reported(*calibration), HasSubstr("p1")) << bad;
    EXPECT_LT(mapping_error_mm(*calibration), 0.03) << bad;
  }
}

TEST(HardPresses, ARadiusThatIsNoneIsRefused) {
  ALLTACT_SKIP_IF_AWAITED();
  for (const double bad : {std::nan(""), 0.0, -4.0, static_cast<double>(kInfinite)}) {
    std::mt19937 random(41);
    std::vector<Press> presses = good_presses(random);
    for (Press& press : presses) press.ball_radius_mm = bad;
    const auto calibration = solved(presses);
    ASSERT_FALSE(calibration.ok()) << bad;
    EXPECT_THAT(calibration.error().sentence(), HasSubstr("radius")) << bad;
  }
}

}  // namespace
}  // namespace alltact
