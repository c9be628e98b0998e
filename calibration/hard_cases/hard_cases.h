// The calculations that plain formulas get wrong where a finger is used: what the plain formula
// makes of each, what ours does, and how wrong ours may be. For the tests, and for whoever wants to
// see that a computer calculates as it should.
//
// A row is a list of questions. Each is put to the plain formula and to ours, and both answers are
// measured by the same rule against the same truth: arithmetic in 50 digits, or what the data were
// made from, never what this program thinks. An answer is numbers, or a refusal in words. Where
// there are numbers to be had a refusal costs coverage; where there are none, the refusal must say
// why. So neither "refused" nor "accepted" throughout can hold a row.
#pragma once

#include <string>
#include <vector>

namespace alltact {

/// What a formula says to one question: numbers, or in words why it has none.
struct HardAnswer {
  std::vector<double> values;  ///< empty: refused
  std::string refusal;
};

struct HardQuestion {
  std::vector<double> truth;  ///< empty: there is no number; the answer must be a refusal ...
  std::vector<std::string> reasons;  ///< ... that holds one of these
  double scale = 1;                  ///< > 0; errors are counted in it: |truth| for relative ones
};

/// How the errors |values - truth| / scale of all answers become one figure. Numbers that are not
/// finite, too many or too few, and numbers or other words where a reason is due make it infinite,
/// but for kWrong, which counts them.
enum class HardMeasure {
  kWorst = 1,  ///< the greatest
  kRms,        ///< root of their mean square
  kBias,       ///< |mean| of the signed errors of the first value
  kBiasInSd,   ///< the same over their standard deviation
  kSpread,     ///< |root mean square - 1|: scale is what there must be
  kPromise,    ///< values are (value, sd): |mean of ((value - truth) / sd)^2 - 1|; no error > scale
  kWrong,      ///< how many are greater than 1, or not as described above; part of all asked
};

/// What is asked, and what both sides answered.
struct HardRow {
  std::string what;   ///< "radius of a speck, 1e-12 to 1e-7 rad"
  std::string plain;  ///< the formula or method that fails: "sqrt(1 - cos^2)"
  std::string unit;   ///< of the figure: "relative", "mm", "px", ...
  double bound = 0;   ///< ours must not exceed it
  HardMeasure measure = HardMeasure::kWorst;
  double least_answered = 1;  ///< of the questions that have a number: the part to be answered
  std::vector<HardQuestion> questions = {};
  std::vector<HardAnswer> plain_answers = {}, our_answers = {};

  void ask(HardQuestion question, HardAnswer plain, HardAnswer ours);
};

struct HardScore {
  double error = 0;     ///< infinite where no number can be given
  double answered = 0;  ///< of the questions that have a number: the part answered; 0 when none has
};

/// One answer for each question of the row.
[[nodiscard]] HardScore score(const HardRow& row, const std::vector<HardAnswer>& answers);

/// A row's figures.
struct HardCase {
  std::string what, plain, unit;  ///< as in HardRow
  HardScore plain_score, our_score;
  double bound = 0, least_answered = 1;

  /// Our error is a number within the bound, and enough was answered.
  [[nodiscard]] bool holds() const { return is_within(our_score); }
  /// The plain formula's is not, or not enough.
  [[nodiscard]] bool plain_fails() const { return !is_within(plain_score); }

 private:
  [[nodiscard]] bool is_within(const HardScore& score) const {
    return score.error <= bound && score.answered >= least_answered;
  }
};

/// The row's figures with `ours` in place of what this program answers.
[[nodiscard]] HardCase judged(const HardRow& row, const std::vector<HardAnswer>& ours);

/// Works out all rows, in a few seconds; every random number has a fixed seed.
[[nodiscard]] std::vector<HardRow> hard_rows();

/// The figures of all rows.
[[nodiscard]] std::vector<HardCase> hard_cases();

}  // namespace alltact
