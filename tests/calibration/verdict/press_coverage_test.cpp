// Repeats count once, whatever their order; far from the presses a line along the face says little.
#include "calibration/verdict/verdict.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::ElementsAre;

std::vector<ContactSpot> at(std::initializer_list<double> along_mm) {
  std::vector<ContactSpot> spots;
  for (const double along : along_mm) spots.push_back({along, 0, 2.5, 90});
  return spots;
}

TEST(PressCoverage, RepeatsCountOnce) {
  std::vector<ContactSpot> spots;
  for (int i = 0; i < 7; ++i) spots.push_back({50 + 0.2 * i, 0.1 * i, 2.5, 90});
  for (int i = 0; i < 7; ++i) spots.push_back({70 - 0.2 * i, 0.1 * i, 2.5, 90});
  std::mt19937 random(11);
  for (int turn = 0; turn < 20; ++turn) {
    std::shuffle(spots.begin(), spots.end(), random);
    const PressCoverage coverage = coverage_of(spots);
    EXPECT_EQ(coverage.positions, 2);
    EXPECT_THAT(coverage.thirds, ElementsAre(0, 1, 1));
  }
}

TEST(PressCoverage, ThirdsAreThoseOfTheFace) {
  EXPECT_THAT(coverage_of(at({10, 45, 80})).thirds, ElementsAre(1, 1, 1));
  EXPECT_THAT(coverage_of(at({-1, 28, 32, 91})).thirds, ElementsAre(2, 1, 1));
  EXPECT_THAT(coverage_of({}).thirds, ElementsAre(0, 0, 0));
}

TEST(PressCoverage, LeverageIsThatOfALine) {
  // Evenly spread positions: 1 / n of the mean, and of the slope about as much.
  std::vector<ContactSpot> even;
  constexpr int kMany = 200;
  for (int i = 0; i < kMany; ++i) even.push_back({90.0 * (i + 0.5) / kMany, 0, 0.01, 90});
  EXPECT_NEAR(coverage_of(even).leverage, 2.0 / kMany, 1e-3);
  // Two near each other: (L^2 / 12 + (L / 2 - mean)^2) / (2 * half the distance squared).
  const double wanted = 90.0 * 90.0 / 12 + 5.0 * 5.0;
  EXPECT_NEAR(coverage_of(at({30, 50})).leverage, 0.5 + wanted / 200, 1e-9);
  EXPECT_EQ(coverage_of(at({49, 52})).leverage, kMaxLeverage);
  EXPECT_EQ(coverage_of(at({49})).leverage, 0);
}

}  // namespace
}  // namespace alltact
