// Every calculation that a plain formula gets wrong: the plain one fails, ours stays within its
// bound. What `alltact check --numerics` shows; and that no row can hold without being answered.
#include "tests/hard_cases/hard_cases.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <set>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// They take seconds to work out.
const std::vector<HardRow>& rows() {
  static const std::vector<HardRow> all = hard_rows();
  return all;
}

TEST(HardCases, OursHoldWhereThePlainFormulaFails) {
  ASSERT_GT(rows().size(), 30U);
  std::set<std::string> names;
  for (const HardRow& row : rows()) {
    const HardCase one = judged(row, row.own_answers);
    std::printf("[ figures  ] %s: plain %.2g, ours %.2g, bound %.2g %s, answered %.3f of %zu\n",
                one.what.c_str(), one.naive_score.error, one.own_score.error, one.bound,
                one.unit.c_str(), one.own_score.answered, row.questions.size());
    EXPECT_TRUE(one.holds()) << one.what;
    EXPECT_TRUE(one.naive_fails()) << one.what;
    // What only just fails would show little.
    EXPECT_GE(one.naive_score.error, 2 * one.own_score.error) << one.what;
    EXPECT_TRUE(names.insert(one.what).second) << one.what;
  }
}

/// What a program that is broken might answer in place of ours.
struct Fault {
  const char* name;
  std::function<HardAnswer(const HardRow&, std::size_t question)> answer;
};

HardAnswer filled(const HardRow& row, std::size_t question, double value) {
  HardAnswer answer = row.own_answers[question];
  const std::size_t count = answer.values.empty() ? 1 : answer.values.size();
  answer.values.assign(count, value);
  return answer;
}

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all{
      {"refused without a reason", [](const HardRow&, std::size_t) { return HardAnswer{}; }},
      {"refused with the reason that is due elsewhere",
       [](const HardRow& row, std::size_t i) {
         HardRefusal due = row.questions[i].due;
         for (const HardQuestion& question : row.questions)
           if (due == HardRefusal::kOther) due = question.due;
         return HardAnswer{{}, due};
       }},
      {"no number", [](const HardRow& row, std::size_t i) { return filled(row, i, NAN); }},
      {"infinite", [](const HardRow& row, std::size_t i) { return filled(row, i, INFINITY); }},
      {"zero", [](const HardRow& row, std::size_t i) { return filled(row, i, 0); }},
      {"sure of nothing: a huge number",
       [](const HardRow& row, std::size_t i) { return filled(row, i, 1e300); }},
      {"a tenth too large",
       [](const HardRow& row, std::size_t i) {
         HardAnswer answer = row.own_answers[i];
         for (double& value : answer.values) value = 1.1 * value + 1;
         return answer;
       }},
      {"the last question refused, the first one wrong",
       [](const HardRow& row, std::size_t i) {
         HardAnswer answer = row.own_answers[i];
         if (i == 0) answer = filled(row, i, 1e9);
         return i + 1 == row.questions.size() ? HardAnswer{} : answer;
       }},
  };
  return all;
}

TEST(HardCases, NoRowHoldsWithoutItsAnswers) {
  for (const HardRow& row : rows()) {
    ASSERT_EQ(row.own_answers.size(), row.questions.size()) << row.what;
    ASSERT_EQ(row.naive_answers.size(), row.questions.size()) << row.what;
    for (const Fault& fault : faults()) {
      std::vector<HardAnswer> answers;
      for (std::size_t i = 0; i < row.questions.size(); ++i)
        answers.push_back(fault.answer(row, i));
      EXPECT_FALSE(judged(row, answers).holds()) << row.what << ": " << fault.name;
    }
  }
}

TEST(HardCases, HalfOfTheAnswersAreNotEnough) {
  for (const HardRow& row : rows()) {
    std::vector<HardAnswer> answers = row.own_answers;
    for (std::size_t i = 0; i < answers.size(); i += 2) answers[i] = HardAnswer{};
    EXPECT_FALSE(judged(row, answers).holds()) << row.what;
  }
}

HardRow small_row(HardMeasure measure) {
  HardRow row{"", "", "", 0.5, measure};
  for (const double truth : {1.0, 2.0, 3.0, 4.0}) row.ask({{truth}, {}, 1.0}, {}, {{truth}});
  return row;
}

TEST(HardCases, MeasuresAreWhatTheySay) {
  const auto error = [](HardMeasure measure, std::vector<double> values) {
    const HardRow row = small_row(measure);
    std::vector<HardAnswer> answers;
    for (const double value : values) answers.push_back({{value}});
    return score(row, answers).error;
  };
  const std::vector<double> off{1.5, 2.5, 2.0, 4.0};  // errors 0.5, 0.5, -1, 0
  EXPECT_DOUBLE_EQ(error(HardMeasure::kWorst, off), 1.0);
  EXPECT_DOUBLE_EQ(error(HardMeasure::kRms, off), std::sqrt(1.5 / 4));
  EXPECT_DOUBLE_EQ(error(HardMeasure::kBias, off), 0.0);
  EXPECT_DOUBLE_EQ(error(HardMeasure::kBias, {2, 3, 4, 5}), 1.0);
  EXPECT_DOUBLE_EQ(error(HardMeasure::kSpread, off), 1 - std::sqrt(1.5 / 4));
  EXPECT_DOUBLE_EQ(error(HardMeasure::kBiasInSd, {1, 2, 3, 6}), 0.5);
  EXPECT_DOUBLE_EQ(error(HardMeasure::kWrong, {2.5, 2, 3, -4}), 0.5);
  EXPECT_EQ(error(HardMeasure::kBias, {1, 2, 3, std::nan("")}), INFINITY);
}

TEST(HardCases, APromiseIsWrongInBothWays) {
  const auto error = [](double sd) {
    const HardRow row = small_row(HardMeasure::kSdAccuracy);
    std::vector<HardAnswer> answers;
    for (const HardQuestion& question : row.questions)
      answers.push_back({{question.truth[0] + 1, sd}});
    return score(row, answers).error;
  };
  EXPECT_DOUBLE_EQ(error(1), 0);
  EXPECT_DOUBLE_EQ(error(10), 0.99);
  EXPECT_DOUBLE_EQ(error(0.5), 3);
  EXPECT_EQ(error(0), INFINITY);
}

TEST(HardCases, ARefusalNeedsItsReason) {
  const HardAnswer one{{1.0}}, folded{{}, HardRefusal::kFoldedLens};
  HardRow row{"", "", "", 0};
  row.ask(expected(1.0), {}, one);
  row.ask(expected_refusal(HardRefusal::kFoldedLens), {}, folded);
  EXPECT_TRUE(judged(row, row.own_answers).holds());
  EXPECT_FALSE(judged(row, {one, HardAnswer{}}).holds());
  EXPECT_FALSE(judged(row, {one, HardAnswer{{}, HardRefusal::kTooDark}}).holds());
  EXPECT_FALSE(judged(row, {one, HardAnswer{{1.0}, HardRefusal::kFoldedLens}}).holds());
  // Nothing that has a number: nothing is shown.
  HardRow only{"", "", "", 0};
  only.ask(expected_refusal(HardRefusal::kFoldedLens), {}, folded);
  EXPECT_FALSE(judged(only, only.own_answers).holds());
}

}  // namespace
}  // namespace alltact
