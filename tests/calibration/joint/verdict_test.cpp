#include "calibration/joint/verdict.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Verdict, HeldOutErrorCountsAndNotTheFlatteringOne) {
  const Verdict worth = verdict({0.01, 0.2, 0, 4});
  EXPECT_EQ(worth.grade, Grade::kUnfit);
  EXPECT_EQ(worth.error_mm, 0.2);
  EXPECT_THAT(worth.sentence.english(), HasSubstr("0.200 mm"));
}

TEST(Verdict, GradesChangeAtTheirLimits) {
  EXPECT_EQ(verdict({0.01, kGoodErrorMm, 0, 4}).grade, Grade::kGood);
  EXPECT_EQ(verdict({0.01, kGoodErrorMm + 1e-9, 0, 4}).grade, Grade::kUsable);
  EXPECT_EQ(verdict({0.01, kUsableErrorMm, 0, 4}).grade, Grade::kUsable);
  EXPECT_EQ(verdict({0.01, kUsableErrorMm + 1e-9, 0, 4}).grade, Grade::kUnfit);
}

TEST(Verdict, WhatIsOffAsAWholeCountsToo) {
  const Verdict worth = verdict({0.01, 0.03, 0.04, 4});
  EXPECT_DOUBLE_EQ(worth.error_mm, 0.05);
  EXPECT_THAT(worth.sentence.english(),
              testing::AllOf(HasSubstr("0.050 mm"), HasSubstr("0.040 mm")));
  EXPECT_EQ(verdict({0.01, 0.03, 0.06, 4}).grade, Grade::kUsable);
}

TEST(Verdict, OnePressProvesNothing) {
  const Verdict worth = verdict({0.001, 0.0, 0, 1});
  EXPECT_EQ(worth.grade, Grade::kUnproven);
  EXPECT_THAT(worth.sentence.english(), HasSubstr("add presses"));
}

TEST(Verdict, NoNumberIsNeverGood) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(verdict({nan, 0.0, 0, 1}).grade, Grade::kUnfit);
  EXPECT_EQ(verdict({nan, std::numeric_limits<double>::infinity(), 0, 3}).grade, Grade::kUnfit);
}

}  // namespace
}  // namespace alltact
