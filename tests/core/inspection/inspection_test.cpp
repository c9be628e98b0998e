// Recipes, decisions by tolerance and uncertainty, and summaries of many frames.
#include "core/inspection/inspection_log.h"
#include "tests/support/program.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

InspectionRecipe some_recipe() {
  InspectionRecipe recipe;
  recipe.name = "seal: \"groove\" №7";
  recipe.readings = {{"depth", Measurand::kStep, {30, -2.5}, {36.25, -2.5}, 0.45, 0.55, {}},
                     {"radius, at most", Measurand::kRadius, {20, -3}, {28, 3}, {}, 4.1, {}},
                     {"1.5", Measurand::kAngle, {20, -3}, {28, 3}, -2.0, {}, {}},
                     {"area", Measurand::kArea, {20, -3}, {28, 3}, {}, {}, {}},
                     {"cut", Measurand::kSectionWidth, {20, -3}, {28, 3}, {}, 1.5, {}},
                     {"cut's area", Measurand::kSectionArea, {20, -3}, {28, 3}, {}, {}, {}},
                     {"cut's depth", Measurand::kSectionDepth, {20, -3}, {28, 3}, {}, {}, {}},
                     {"grain", Measurand::kRoughness, {20, -3}, {28, 3}, {}, 0.01, {4, 0.8}}};
  return recipe;
}

TEST(InspectionRecipe, ComesBackAsItWasSaved) {
  const test::TemporaryFolder folder;
  const InspectionRecipe recipe = some_recipe();
  ASSERT_TRUE(recipe.save(folder / "a.yaml").ok());
  const auto back = InspectionRecipe::load(folder / "a.yaml");
  ASSERT_TRUE(back.ok()) << back.error().sentence();
  EXPECT_EQ(*back, recipe);
  EXPECT_EQ(back->to_yaml(), recipe.to_yaml());
}

TEST(InspectionRecipe, NamesWhatIsWrong) {
  const auto refusal = [](const std::string& readings) {
    const auto read = InspectionRecipe::parse(
        "format: alltact-inspection-recipe/1\nreadings:\n" + readings, "a.yaml");
    return read ? std::string() : read.error().sentence();
  };
  const std::string good =
      "  - {name: \"a\", what: step, a_mm: [1, 2], b_mm: [3, 4], lower: 1, upper: 2}\n";
  EXPECT_EQ(refusal(good), "");
  EXPECT_THAT(refusal(good + good), HasSubstr("has two of the name 'a'"));
  EXPECT_THAT(refusal("  - {name: \"a\", what: steps, a_mm: [1, 2], b_mm: [3, 4]}\n"),
              HasSubstr("what"));
  EXPECT_THAT(
      refusal("  - {name: \"a\", what: step, a_mm: [1, 2], b_mm: [3, 4], lower: 2, upper: 1}\n"),
      HasSubstr("is not above the lower limit"));
  EXPECT_THAT(refusal("  - {name: \"\", what: step, a_mm: [1, 2], b_mm: [3, 4]}\n"),
              HasSubstr("is empty"));
  EXPECT_THAT(refusal("  - {name: \"a\", what: step, a_mm: [1], b_mm: [3, 4]}\n"),
              HasSubstr("a_mm"));
  EXPECT_THAT(refusal("  - {name: \"a\", what: roughness, a_mm: [1, 2], b_mm: [3, 4], "
                      "form_degree: 5}\n"),
              HasSubstr("form_degree"));
  EXPECT_THAT(refusal("  - {name: \"a\", what: roughness, a_mm: [1, 2], b_mm: [3, 4], "
                      "lambda_c_mm: 0}\n"),
              HasSubstr("lambda_c_mm"));
  EXPECT_THAT(InspectionRecipe::parse("format: other/1\n", "a.yaml").error().sentence(),
              HasSubstr("a.yaml"));
}

TEST(InspectionRecipe, FindsAFreeName) {
  InspectionRecipe recipe = some_recipe();
  EXPECT_EQ(recipe.free_name("volume"), "volume");
  EXPECT_EQ(recipe.free_name("depth"), "depth 2");
  recipe.readings[1].name = "depth 2";
  EXPECT_EQ(recipe.free_name("depth"), "depth 3");
}

Conformity decide(double value, double sd, std::optional<double> lower, std::optional<double> upper,
                  bool is_lower_bound = false) {
  FaceReading reading;
  reading.measured = MeasuredValue{value, sd};
  reading.is_lower_bound = is_lower_bound;
  return conformity(reading, {"a", Measurand::kStep, {}, {}, lower, upper, {}});
}

TEST(Conformity, LeavesAGuardBandAtEachLimit) {
  constexpr double kSd = 0.01, kGuard = 1.6449 * kSd;
  EXPECT_EQ(decide(0.5, kSd, 0.4, 0.6), Conformity::kPass);
  EXPECT_EQ(decide(0.4 + kGuard + 1e-9, kSd, 0.4, 0.6), Conformity::kPass);
  EXPECT_EQ(decide(0.4 + kGuard - 1e-9, kSd, 0.4, 0.6), Conformity::kUndecided);
  EXPECT_EQ(decide(0.6 + kGuard - 1e-9, kSd, 0.4, 0.6), Conformity::kUndecided);
  EXPECT_EQ(decide(0.6 + kGuard + 1e-9, kSd, 0.4, 0.6), Conformity::kFail);
  EXPECT_EQ(decide(0.4 - kGuard - 1e-9, kSd, 0.4, 0.6), Conformity::kFail);
  EXPECT_EQ(decide(100, kSd, 0.4, {}), Conformity::kPass);
  EXPECT_EQ(decide(-100, kSd, {}, 0.6), Conformity::kPass);
  EXPECT_EQ(decide(1, kSd, {}, {}), Conformity::kNoTolerance);
}

TEST(Conformity, IsUndecidedWhereTheUncertaintyIsUnknownOrTheLayerEnds) {
  EXPECT_EQ(decide(0.5, 0, 0.4, 0.6), Conformity::kUndecided);
  EXPECT_EQ(decide(0.5, std::numeric_limits<double>::infinity(), 0.4, 0.6), Conformity::kUndecided);
  EXPECT_EQ(decide(0.5, 0.01, 0.4, 0.6, true), Conformity::kUndecided) << "it may be more";
  EXPECT_EQ(decide(0.7, 0.01, 0.4, 0.6, true), Conformity::kFail) << "it is at least that";
  EXPECT_EQ(decide(0.3, 0.01, 0.4, 0.6, true), Conformity::kUndecided);
  FaceReading none;
  EXPECT_EQ(conformity(none, {"a", Measurand::kStep, {}, {}, 0.4, 0.6, {}}),
            Conformity::kNotMeasured);
}

/// A true value exactly at a limit passes in 5 % of measurements, and fails in as many.
TEST(Conformity, ErrsInFivePercentAtALimit) {
  constexpr int kReadings = 20000;
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.02);
  int passed = 0, failed = 0;
  for (int i = 0; i < kReadings; ++i) {
    const Conformity one = decide(0.6 + noise(random), 0.02, 0.0, 0.6);
    passed += one == Conformity::kPass;
    failed += one == Conformity::kFail;
  }
  EXPECT_NEAR(passed, 0.05 * kReadings, 3.5 * std::sqrt(0.05 * kReadings));
  EXPECT_NEAR(failed, 0.05 * kReadings, 3.5 * std::sqrt(0.05 * kReadings));
}

constexpr double kPixelMm = 0.05;

/// A line of 121 points over a face that rises along it; `depth_mm` by mm along the line, from -3.
SurfaceLine line_over(const std::function<double(double)>& depth_mm, double noise_mm,
                      unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  SurfaceLine line;
  for (int i = -60; i <= 60; ++i) {
    const double s = kPixelMm * i;
    SurfacePoint point;
    point.untouched_mm = {0.8 * s, 0, 60 + 0.6 * s};  // along it: s
    point.depth_mm = depth_mm(s) + noise_mm * normal(random);
    point.noise_mm = noise_mm;
    line.patch.points.push_back(point);
    line.along_mm.push_back(s + 3);
  }
  return line;
}

double notch(double s) { return std::max(0.0, 0.8 - 0.5 * std::abs(s - 0.3)); }

TEST(LineSection, ANotchHasItsDepthWidthAndArea) {
  const auto section = section_of(line_over(notch, 0, 1));
  ASSERT_TRUE(section) << section.error().sentence();
  EXPECT_NEAR(section->depth_mm.value, 0.8, 1e-12);
  ASSERT_TRUE(section->width_mm);
  EXPECT_NEAR(section->width_mm->value, 1.6, 1e-12) << "2 x 0.4 mm / 0.5";
  // A triangle of 0.8 mm by 3.2 mm without its tips, which are shallower; 0.8 of it across z.
  const double tips = kLeastDepthMm * kLeastDepthMm / 0.5;
  EXPECT_NEAR(section->area_mm2.value, 0.8 * (0.8 * 0.8 / 0.5 - tips), 1e-9);
  EXPECT_FALSE(section->is_lower_bound);
}

TEST(LineSection, IsAsCertainAsItSays) {
  constexpr int kRuns = 400;
  double width = 0, area = 0;
  const double true_area = section_of(line_over(notch, 0, 1))->area_mm2.value;
  for (unsigned seed = 0; seed < kRuns; ++seed) {
    const auto section = section_of(line_over(notch, 0.004, seed));
    ASSERT_TRUE(section && section->width_mm);
    width += std::pow((section->width_mm->value - 1.6) / section->width_mm->sd, 2);
    area += std::pow((section->area_mm2.value - true_area) / section->area_mm2.sd, 2);
  }
  EXPECT_GT(width / kRuns, 0.4);
  EXPECT_LT(width / kRuns, 1.6);
  EXPECT_NEAR(area / kRuns, 1, 0.35);
}

/// Depths that are 2 % uncertain as a whole: the width stays, depth and area follow.
TEST(LineSection, WhatIsCommonToAllDepthsMovesDepthAndAreaOnly) {
  SurfaceLine line = line_over(notch, 0, 1);
  for (SurfacePoint& point : line.patch.points) point.common_mm = 0.02 * point.depth_mm;
  const auto section = section_of(line);
  ASSERT_TRUE(section && section->width_mm);
  EXPECT_NEAR(section->depth_mm.sd, 0.016, 1e-9);
  EXPECT_NEAR(section->area_mm2.sd, 0.02 * section->area_mm2.value, 1e-4);
  EXPECT_NEAR(section->width_mm->sd, 0, 1e-9);
}

TEST(LineSection, SaysWhyThereIsNone) {
  EXPECT_THAT(section_of(line_over([](double) { return 0.01; }, 0, 1)).error().sentence(),
              HasSubstr("nothing here is deeper than 0.05 mm"));
  EXPECT_FALSE(section_of(SurfaceLine()));
  const auto rising = section_of(line_over([](double s) { return 0.2 + 0.1 * (s + 3); }, 0, 1));
  ASSERT_TRUE(rising);
  EXPECT_THAT(rising->width_mm.error().sentence(), HasSubstr("the line ends before half"));
  SurfaceLine line = line_over(notch, 0, 1);
  line.patch.points[66].is_limit = true;
  const auto limited = section_of(line);
  ASSERT_TRUE(limited);
  EXPECT_TRUE(limited->is_lower_bound);
  EXPECT_THAT(limited->width_mm.error().sentence(), HasSubstr("limit of the measuring range"));
}

InspectionLog log_of(const std::vector<std::optional<double>>& values, double sd, bool has_times) {
  InspectionLog log;
  log.recipe.readings = {{"gap, \"left\"", Measurand::kDistance, {1, 2}, {3, 4}, 0.9, 2.0, {}}};
  for (std::size_t i = 0; i < values.size(); ++i) {
    InspectedReading one;
    if (values[i]) one.reading.measured = MeasuredValue{*values[i], sd};
    if (!values[i]) one.reading.reason = en::say("it is dark");
    one.conformity = conformity(one.reading, log.recipe.readings.front());
    InspectedRow row{i, "frame_" + std::to_string(i), {}, {one}};
    if (has_times) row.time_s = 0.5 * static_cast<double>(i);
    log.rows.push_back(row);
  }
  return log;
}

TEST(InspectionLog, SumsUpEveryReading) {
  const InspectionLog log = log_of({1.0, 1.1, {}, 1.3, 1.4}, 0.01, true);
  const auto summaries = log.summaries();
  ASSERT_EQ(summaries.size(), 1U);
  const ReadingSummary& one = summaries.front();
  EXPECT_EQ(one.measured, 4U);
  EXPECT_EQ(one.passed, 4U);
  EXPECT_DOUBLE_EQ(*one.mean, 1.2);
  EXPECT_NEAR(*one.sd, std::sqrt((0.04 + 0.01 + 0.01 + 0.04) / 3), 1e-12);
  EXPECT_EQ(*one.min, 1.0);
  EXPECT_EQ(*one.max, 1.4);
  ASSERT_TRUE(one.trend.has_value());
  EXPECT_TRUE(one.is_trend_per_second);
  EXPECT_NEAR(one.trend->value, 0.2, 1e-12) << "0.1 mm a frame, two frames a second";
  EXPECT_NEAR(one.trend->sd, 0, 1e-9);
  EXPECT_EQ(log.verdict(), Conformity::kNotMeasured) << "a frame could not be read";
  const auto by_frame = log_of({1.0, 1.1, 1.2}, 0.01, false).summaries().front();
  EXPECT_FALSE(by_frame.is_trend_per_second);
  EXPECT_NEAR(by_frame.trend->value, 0.1, 1e-12);
  EXPECT_FALSE(log_of({1.0, 1.1}, 0.01, false).summaries().front().trend.has_value());
}

/// The trend's standard deviation holds the truth as often as that of a normal distribution.
TEST(InspectionLog, TheTrendIsAsCertainAsItSays) {
  constexpr int kLogs = 2000, kFrames = 30;
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 0.03);
  int within = 0;
  for (int k = 0; k < kLogs; ++k) {
    std::vector<std::optional<double>> values;
    for (int i = 0; i < kFrames; ++i) values.emplace_back(1 + 0.02 * i + noise(random));
    const auto trend = log_of(values, 0.03, false).summaries().front().trend;
    within += std::abs(trend->value - 0.02) < trend->sd;
  }
  // Student's t of 28 degrees of freedom is within 1 in 67.4 %.
  EXPECT_NEAR(within, 0.674 * kLogs, 3.5 * std::sqrt(0.22 * kLogs));
}

TEST(InspectionLog, TheVerdictIsThatOfTheWorstReading) {
  EXPECT_EQ(log_of({1.2, 1.3}, 0.01, false).verdict(), Conformity::kPass);
  EXPECT_EQ(log_of({1.2, 0.905}, 0.01, false).verdict(), Conformity::kUndecided);
  EXPECT_EQ(log_of({1.2, {}, 0.5}, 0.01, false).verdict(), Conformity::kFail);
  InspectionLog none = log_of({1.2}, 0.01, false);
  none.recipe.readings.front().lower.reset();
  none.recipe.readings.front().upper.reset();
  EXPECT_EQ(none.verdict(), Conformity::kNoTolerance);
}

TEST(InspectionLog, IsATableOfOneLineForEachReading) {
  EXPECT_EQ(log_of({1.25, {}}, 0.0123, true).to_csv(),
            "index,frame,time_s,reading,what,value,sd,unit,lower,upper,decision,remark\n"
            "0,frame_0,0,\"gap, \"\"left\"\"\",distance,1.25,0.0123,mm,0.9,2,pass,\n"
            "1,frame_1,0.5,\"gap, \"\"left\"\"\",distance,,,mm,0.9,2,not measured,it is dark\n");
}

}  // namespace
}  // namespace alltact
