// Faults that are known, made by simulation: the rules must see those that can be seen, be silent
// where there is none, and what cannot be seen is said to be so.
#include "core/finger/mapping.h"
#include "tests/support/simulated_fault.h"

#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

auto says(const char* words) { return testing::Property(&Message::english, HasSubstr(words)); }

SimulatedCalibration made(Fault fault, std::uint64_t seed, bool correct_light = true) {
  auto result = simulate_calibration(fault, seed, correct_light, Job());
  EXPECT_TRUE(result.ok()) << result.error().sentence();
  return std::move(result).value();
}

constexpr std::uint64_t kSeeds = 8;

TEST(FaultSigns, AreSilentOnGoodDataAndNameTheRightFault) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EXPECT_THAT(fault_signs(made(Fault::kNone, seed).signs), IsEmpty()) << seed;
    EXPECT_THAT(fault_signs(made(Fault::kLooseSkin, seed).signs), IsEmpty()) << seed;
    EXPECT_THAT(fault_signs(made(Fault::kAutomaticExposure, seed).signs),
                ElementsAre(says("from press to press")))
        << seed;
    EXPECT_THAT(fault_signs(made(Fault::kBrighterLight, seed).signs),
                ElementsAre(says("brighter in all presses")))
        << seed;
  }
}

TEST(FaultSigns, TellHowMuchTheLightHasChanged) {
  for (const PressSign& sign : made(Fault::kBrighterLight, 3).signs)
    EXPECT_NEAR(sign.light_change, 0.05, 0.005);
  const auto signs = made(Fault::kAutomaticExposure, 3).signs;
  ASSERT_EQ(signs.size(), 4U);
  const double gains[] = {0, 0.06, -0.05, 0.03};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(signs[i].light_change, gains[i], 0.006);
}

/// A wrong radius makes wrong depths that agree with each other: no residual shows it.
TEST(FaultSigns, AWrongRadiusCannotBeSeenAndIsAsWrongAsItIs) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const SimulatedCalibration good = made(Fault::kNone, seed),
                               wrong = made(Fault::kWrongRadius, seed);
    EXPECT_THAT(fault_signs(wrong.signs), IsEmpty());
    EXPECT_LT(wrong.calibration.held_out_mm, 2 * good.calibration.held_out_mm + 0.005);
    const auto right = Mapping::create(good.calibration.mapping);
    const auto scaled = Mapping::create(wrong.calibration.mapping);
    ASSERT_TRUE(right.ok() && scaled.ok());
    const double x = 0.6 * right->x_max();
    EXPECT_NEAR(scaled->depth_mm(x) / right->depth_mm(x), 1 / 1.1, 0.03) << seed;
  }
}

/// Unless it is corrected, a change of the light shifts every press by what it is itself.
TEST(FaultSigns, OtherLightShiftsAllDepthsUnlessItIsCorrected) {
  const auto deepest = [](const SimulatedCalibration& calibration) {
    double sum = 0;
    for (const BallFit& ball : calibration.calibration.balls) sum += ball.depth_mm;
    return sum / static_cast<double>(calibration.calibration.balls.size());
  };
  const double good = deepest(made(Fault::kNone, 5));
  EXPECT_NEAR(deepest(made(Fault::kBrighterLight, 5, true)), good, 0.02);
  EXPECT_GT(std::abs(deepest(made(Fault::kBrighterLight, 5, false)) - good), 0.05);
}

TEST(FaultSigns, AreTheSameEveryTime) {
  const SimulatedCalibration one = made(Fault::kMovedCamera, 4), two = made(Fault::kMovedCamera, 4);
  EXPECT_EQ(one.calibration.residual_mm, two.calibration.residual_mm);
  ASSERT_EQ(one.residuals.size(), two.residuals.size());
  EXPECT_EQ(one.residuals.back().samples.back().residual_mm,
            two.residuals.back().samples.back().residual_mm);
}

TEST(FaultSigns, PosesThatWereNeverRecordedAreCounted) {
  EXPECT_THAT(fault_signs({{0, true}, {0, false}, {0, false}}), ElementsAre(says("in 2 of 3")));
  EXPECT_THAT(fault_signs({{0.05, false}}), ElementsAre(says("brighter"), says("in 1 of 1")));
  EXPECT_THAT(fault_signs({{0, true}, {0, false}}), IsEmpty());
  EXPECT_THAT(fault_signs({}), IsEmpty());
}

}  // namespace
}  // namespace alltact
