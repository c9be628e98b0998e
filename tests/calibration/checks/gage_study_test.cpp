// Gage studies against NIST's certified analyses of variance, AIAG's published example, and worlds
// whose variances are known.
#include "calibration/checks/gage_study.h"

#include "calibration/checks/gage_readings.h"
#include "tests/support/program.h"

#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace alltact {
namespace {

using testing::HasSubstr;

// One-way sets of the Statistical Reference Datasets: treatments are parts, with one operator.

struct Certified {
  std::string name;
  double between_ss, within_ss, f, r_squared;
  int between_df, within_df;
};

void expect_certified(const std::string& csv, const Certified& certified) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "nist.csv", csv);
  const auto table = read_gage_table(folder / "nist.csv");
  ASSERT_TRUE(table.ok()) << table.error().sentence();
  const auto study = gage_study(table->readings);
  ASSERT_TRUE(study.ok()) << study.error().sentence();
  const auto nine_digits = [&](double value, double truth, const char* what) {
    EXPECT_NEAR(value / truth, 1, 5e-10) << certified.name << ' ' << what;
  };
  nine_digits(study->by_part.ss, certified.between_ss, "between");
  nine_digits(study->repetition.ss, certified.within_ss, "within");
  nine_digits(*study->by_part.f, certified.f, "F");
  nine_digits(study->by_part.ss / study->total.ss, certified.r_squared, "R squared");
  nine_digits(study->repeatability, std::sqrt(certified.within_ss / certified.within_df), "sd");
  EXPECT_EQ(study->by_part.df, certified.between_df) << certified.name;
  EXPECT_EQ(study->repetition.df, certified.within_df) << certified.name;
}

/// NIST's sets of Simon and Lesage: 0.2 for the first treatment and repeat, then 0.1 and 0.3 in
/// turns, upon a large constant.
std::string simon_lesage(const std::string& constant, int repeats) {
  std::string csv = "part,value\n";
  const auto tenths = [](int i) { return i == 0 ? 2 : i % 2 == 1 ? 1 : 3; };
  for (int treatment = 0; treatment < 9; ++treatment)
    for (int repeat = 0; repeat < repeats; ++repeat)
      csv += fmt::format("t{},{}.{}\n", treatment, constant, tenths(treatment) + tenths(repeat));
  return csv;
}

TEST(GageStudy, AgreesWithSimonAndLesagesSetsToNineDigits) {
  int number = 1;
  for (const char* constant : {"1", "1000000", "1000000000000"})
    for (const int repeats : {21, 201, 2001})
      expect_certified(
          simon_lesage(constant, repeats),
          {fmt::format("SmLs0{}", number++), 1.68 * repeats / 21, 0.09 * (repeats - 1),
           static_cast<double>(repeats), 8.0 * repeats / (8.0 * repeats + 9.0 * (repeats - 1)), 8,
           9 * (repeats - 1)});
}

TEST(GageStudy, AgreesWithTheSetsOfMeasurementsToNineDigits) {
  const auto csv = [](const std::vector<std::vector<std::string>>& groups) {
    std::string text = "part;reading\n";
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (const std::string& value : groups[i]) text += fmt::format("{};{}\n", i + 1, value);
    return text;
  };
  expect_certified(csv({{"196.3052", "196.1240", "196.1890", "196.2569", "196.3403"},
                        {"196.3042", "196.3825", "196.1669", "196.3257", "196.0422"},
                        {"196.1303", "196.2005", "196.2889", "196.0343", "196.1811"},
                        {"196.2795", "196.1748", "196.1494", "196.1485", "195.9885"},
                        {"196.2119", "196.1051", "196.1850", "196.0052", "196.2090"}}),
                   {"SiRstv", 5.11462616000000e-02, 2.16636560000000e-01, 1.18046237440255e+00,
                    1.90999039051129e-01, 4, 20});
  expect_certified(csv({{"107.8681568", "107.8681465", "107.8681572", "107.8681785", "107.8681446",
                         "107.8681903", "107.8681526", "107.8681494", "107.8681616", "107.8681587",
                         "107.8681519", "107.8681486", "107.8681419", "107.8681569", "107.8681508",
                         "107.8681672", "107.8681385", "107.8681518", "107.8681662", "107.8681424",
                         "107.8681360", "107.8681333", "107.8681610", "107.8681477"},
                        {"107.8681079", "107.8681344", "107.8681513", "107.8681197", "107.8681604",
                         "107.8681385", "107.8681642", "107.8681365", "107.8681151", "107.8681082",
                         "107.8681517", "107.8681448", "107.8681198", "107.8681482", "107.8681334",
                         "107.8681609", "107.8681101", "107.8681512", "107.8681469", "107.8681360",
                         "107.8681254", "107.8681261", "107.8681450", "107.8681368"}}),
                   {"AtmWtAg", 3.63834187500000e-09, 1.04951729166667e-08, 1.59467335677930e+01,
                    2.57426544538321e-01, 1, 46});
}

/// 10 parts, 3 appraisers, 3 trials; AIAG, Measurement Systems Analysis, 4th edition, figure
/// III-B 6.
std::vector<GageReading> aiag_readings() {
  const std::vector<std::pair<std::string, std::vector<double>>> trials{
      {"A", {0.29, -0.56, 1.34, 0.47, -0.80, 0.02, 0.59, -0.31, 2.26, -1.36}},
      {"A", {0.41, -0.68, 1.17, 0.50, -0.92, -0.11, 0.75, -0.20, 1.99, -1.25}},
      {"A", {0.64, -0.58, 1.27, 0.64, -0.84, -0.21, 0.66, -0.17, 2.01, -1.31}},
      {"B", {0.08, -0.47, 1.19, 0.01, -0.56, -0.20, 0.47, -0.63, 1.80, -1.68}},
      {"B", {0.25, -1.22, 0.94, 1.03, -1.20, 0.22, 0.55, 0.08, 2.12, -1.62}},
      {"B", {0.07, -0.68, 1.34, 0.20, -1.28, 0.06, 0.83, -0.34, 2.19, -1.50}},
      {"C", {0.04, -1.38, 0.88, 0.14, -1.46, -0.29, 0.02, -0.46, 1.77, -1.49}},
      {"C", {-0.11, -1.13, 1.09, 0.20, -1.07, -0.67, 0.01, -0.56, 1.45, -1.77}},
      {"C", {-0.15, -0.96, 0.67, 0.11, -1.45, -0.49, 0.21, -0.49, 1.87, -2.16}}};
  std::vector<GageReading> readings;
  for (const auto& [appraiser, values] : trials)
    for (std::size_t part = 0; part < values.size(); ++part)
      readings.push_back({std::to_string(part + 1), appraiser, values[part]});
  return readings;
}

TEST(GageStudy, AgreesWithThePublishedExample) {
  const auto study = gage_study(aiag_readings());
  ASSERT_TRUE(study.ok());
  EXPECT_TRUE(study->is_pooled) << "the interaction is not significant";
  EXPECT_NEAR(study->repeatability, 0.199933, 5e-7);
  EXPECT_NEAR(study->reproducibility, 0.226838, 5e-7);
  EXPECT_NEAR(study->gage, 0.302373, 2e-6) << "from rounded parts";
  EXPECT_NEAR(study->parts_sd, 1.042327, 5e-7);
  EXPECT_NEAR(study->percent(study->gage), 27.9, 0.05);
  EXPECT_NEAR(study->percent(study->repeatability), 18.4, 0.05);
  EXPECT_NEAR(study->percent(study->reproducibility), 20.9, 0.05);
  EXPECT_NEAR(study->percent(study->parts_sd), 96.0, 0.05);
  EXPECT_EQ(study->categories, 4);
  EXPECT_EQ(study->repeats, 3);
  EXPECT_THAT(study->operators, testing::ElementsAre("A", "B", "C"));
  EXPECT_NEAR(GageStudy::percent_of(4, study->gage), 45.36, 0.01);
}

/// Sums of squares add up, whatever is measured; the order of readings, a constant and a scale do
/// not matter.
RC_GTEST_PROP(GageStudy, ObeysTheLawsOfAnalysesOfVariance, ()) {
  const int parts = *rc::gen::inRange(2, 6), operators = *rc::gen::inRange(1, 5);
  const int repeats = *rc::gen::inRange(2, 5);
  const auto tenths = *rc::gen::container<std::vector<int>>(
      static_cast<std::size_t>(parts * operators * repeats), rc::gen::inRange(-100, 100));
  std::vector<GageReading> readings, shifted;
  double squares = 0, mean = 0;
  for (const int value : tenths) mean += 0.1 * value / static_cast<double>(tenths.size());
  for (std::size_t i = 0; i < tenths.size(); ++i) {
    const auto n = static_cast<int>(i);
    readings.push_back(
        {std::to_string(n % parts), std::to_string(n / parts % operators), 0.1 * tenths[i]});
    shifted.push_back(readings.back());
    shifted.back().value = 5000 - 3 * readings.back().value;
    squares += std::pow(readings.back().value - mean, 2);
  }
  std::reverse(shifted.begin(), shifted.end());
  const auto study = gage_study(readings), other = gage_study(shifted);
  RC_ASSERT(study.ok());
  RC_ASSERT(other.ok());
  RC_ASSERT(std::abs(study->total.ss - squares) <= 1e-9 * (1 + squares));
  RC_ASSERT(study->total.df == study->by_part.df + study->by_operator.df + study->interaction.df +
                                   study->repetition.df);
  RC_ASSERT(std::abs(other->gage - 3 * study->gage) <= 1e-7);
  RC_ASSERT(std::abs(other->parts_sd - 3 * study->parts_sd) <= 1e-7);
  RC_ASSERT(study->gage_95.low <= study->gage && study->gage <= study->gage_95.high);
  RC_ASSERT(std::isfinite(study->gage_95.high));
}

/// Intervals of 95 % hold the true standard deviation in 95 % of many random studies.
TEST(GageStudy, IntervalsHoldTheTruthAsOftenAsTheySay) {
  constexpr int kStudies = 2000, kParts = 8, kOperators = 4, kRepeats = 3;
  struct World {
    double part, person, interaction, repetition;
  };
  for (const World& world : {World{1, 0.3, 0, 0.2}, World{0.5, 0, 0, 0.4}, World{1, 0.2, 0.3, 0.2},
                             World{0.1, 0.02, 0, 0.4}}) {
    int repeatability = 0, gage = 0;
    const double true_gage = std::sqrt(std::pow(world.person, 2) + std::pow(world.interaction, 2) +
                                       std::pow(world.repetition, 2));
    for (int k = 0; k < kStudies; ++k) {
      std::mt19937_64 random(static_cast<std::uint64_t>(k));
      std::normal_distribution<double> normal;
      std::vector<double> parts, operators;
      for (int i = 0; i < kParts; ++i) parts.push_back(world.part * normal(random));
      for (int i = 0; i < kOperators; ++i) operators.push_back(world.person * normal(random));
      std::vector<GageReading> readings;
      for (int p = 0; p < kParts; ++p)
        for (int o = 0; o < kOperators; ++o) {
          const double both = world.interaction * normal(random);
          for (int r = 0; r < kRepeats; ++r)
            readings.push_back({std::to_string(p), std::to_string(o),
                                parts[static_cast<std::size_t>(p)] +
                                    operators[static_cast<std::size_t>(o)] + both +
                                    world.repetition * normal(random)});
        }
      const auto study = gage_study(readings);
      ASSERT_TRUE(study.ok());
      const auto holds = [](const SdInterval& of, double truth) {
        return of.low <= truth && truth <= of.high;
      };
      repeatability += holds(study->repeatability_95, world.repetition);
      gage += holds(study->gage_95, true_gage);
    }
    EXPECT_GE(gage, 0.93 * kStudies) << world.person;
    if (world.interaction > 0) continue;  // then pooling, which is a choice, may take it in
    EXPECT_NEAR(repeatability, 0.95 * kStudies, 0.02 * kStudies) << world.repetition;
  }
}

TEST(GageStudy, NamesWhatIsMissing) {
  const auto refusal = [](const std::vector<GageReading>& readings) {
    const auto study = gage_study(readings);
    return study ? std::string() : study.error().sentence();
  };
  EXPECT_THAT(refusal({}), HasSubstr("needs two parts or two operators"));
  EXPECT_THAT(refusal({{"a", "Ann", 1}, {"a", "Ann", 2}}),
              HasSubstr("needs two parts or two operators"));
  EXPECT_THAT(refusal({{"a", "Ann", 1}, {"b", "Bob", 2}}),
              HasSubstr("only one reading of a by Ann"));
  EXPECT_THAT(refusal({{"a", "Ann", 1}, {"a", "Ann", 1}, {"b", "Bob", 2}}),
              HasSubstr("no reading of a by Bob"));
  EXPECT_THAT(
      refusal(
          {{"a", "Ann", 1}, {"a", "Ann", 1}, {"b", "Ann", 2}, {"b", "Ann", 2}, {"b", "Ann", 2}}),
      HasSubstr("3 readings of b by Ann, but 2 of a by Ann"));
  EXPECT_THAT(refusal({{"a", "Ann", NAN}}), HasSubstr("a reading of a is no number"));
}

/// Without any variation nothing is divided by 0.
TEST(GageStudy, EqualReadingsHaveNoVariation) {
  const auto study = gage_study({{"a", "A", 2}, {"a", "A", 2}, {"b", "A", 2}, {"b", "A", 2}});
  ASSERT_TRUE(study.ok());
  EXPECT_EQ(study->gage, 0);
  EXPECT_EQ(study->percent(study->gage), 0);
  EXPECT_FALSE(study->by_part.f.has_value());
  EXPECT_EQ(study->categories, 0);
}

TEST(GageStudy, TheLastReadingsOfEachCombinationCount) {
  std::size_t left_out = 0;
  const auto last = balanced(
      {{"a", "A", 1}, {"a", "A", 2}, {"b", "A", 3}, {"a", "A", 4}, {"b", "A", 5}}, left_out);
  EXPECT_EQ(left_out, 1U);
  ASSERT_EQ(last.size(), 4U);
  EXPECT_EQ(last[0].value, 2);
  EXPECT_EQ(last[3].value, 5);
}

// Readings from tables and checks.

TEST(GageReadings, OfTablesOfOtherProgramsAreInMm) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.csv",
                   "Specimen;Appraiser;Reading [um]\nA;Ann;1500,5\nB;Bob;-2,25\n");
  const auto read = read_gage_table(folder / "a.csv");
  ASSERT_TRUE(read.ok()) << read.error().sentence();
  ASSERT_EQ(read->readings.size(), 2U);
  EXPECT_EQ(read->readings[0].operator_name, "Ann");
  EXPECT_EQ(read->readings[1].part, "B");
  EXPECT_DOUBLE_EQ(read->origin_mm, 1.5005);
  EXPECT_DOUBLE_EQ(read->readings[1].value, -0.00225 - 1.5005);
  test::write_text(folder / "b.csv", "part,operator\nA,Ann\n");
  EXPECT_THAT(read_gage_table(folder / "b.csv").error().sentence(), HasSubstr("value_mm"));
  test::write_text(folder / "c.csv", "part,operator,value_mm\nA,,1\n");
  EXPECT_THAT(read_gage_table(folder / "c.csv").error().sentence(), HasSubstr("c.csv"));
}

}  // namespace
}  // namespace alltact
