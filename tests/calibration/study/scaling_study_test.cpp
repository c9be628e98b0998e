#include "calibration/study/scaling_study.h"

#include "calibration/study/calibrating_study.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

TEST(Exponent, IsThatOfThePowerThatMadeTheTimes) {
  std::vector<double> x, linear, square, bent;
  for (const double size : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
    x.push_back(size);
    linear.push_back(3 * size);
    square.push_back(0.2 * size * size);
    bent.push_back(size < 100 ? 7 : 0.07 * std::pow(size, 1.5));
  }
  EXPECT_NEAR(exponent_of(x, linear).value(), 1, 1e-12);
  EXPECT_NEAR(exponent_of(x, square).value(), 2, 1e-12);
  EXPECT_NEAR(exponent_of(x, bent).value(), 1.5, 1e-12) << "of the upper half alone";
  EXPECT_FALSE(exponent_of({5}, {1}));
  EXPECT_FALSE(exponent_of({5, 5}, {1, 2}));
  EXPECT_FALSE(exponent_of({1, 10, 100}, {1, 0, -3}));
}

TEST(CalibratingChoices, AskForOneMoreThanThereIs) {
  for (const int presses : {1, 6, 9, CalibratingBench::kMaxPresses}) {
    CalibratingChoice base;
    base.presses = presses;
    for (const bool quick : {true, false}) {
      const auto choices = calibrating_choices(base, quick);
      EXPECT_EQ(choices.front(), base);
      std::set<int> counts;
      for (const CalibratingChoice& choice : choices) {
        EXPECT_GE(choice.presses, 1);
        EXPECT_LE(choice.presses, CalibratingBench::kMaxPresses);
        EXPECT_EQ(std::count(choices.begin(), choices.end(), choice), 1);
        if (choice.images == 1 && choice.method == CalibrationMethod::kJoint)
          counts.insert(choice.presses);
      }
      EXPECT_EQ(counts.count(presses + 1), presses < CalibratingBench::kMaxPresses ? 1U : 0U);
      EXPECT_TRUE(std::any_of(choices.begin(), choices.end(), [&](const auto& choice) {
        return choice.presses == presses && choice.images > 1;
      }));
    }
  }
  Finger finger;
  EXPECT_EQ(choice_of_finger(finger), CalibratingChoice{});
  finger.mapping_record.emplace();
  finger.mapping_record->presses.assign(9, "press");
  EXPECT_EQ(choice_of_finger(finger).presses, 9);
}

}  // namespace
}  // namespace alltact
