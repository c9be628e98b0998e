// Calculations in which naive formulas fail under a finger's conditions: the result of the naive
// formula, that of this program, and the permitted error. For the tests, and for users who verify
// that a computer calculates correctly.
//
// A row is a list of questions to both methods. The same rule measures both answers against the
// same truth: arithmetic in 50 digits, or the data's generator, never this program's own result. An
// answer is numbers, or a refusal with its kind. Where numbers exist a refusal costs coverage;
// where none exist, the refusal must be of the due kind. Neither constant refusal nor constant
// acceptance passes a row.
#pragma once

#include "core/base/result.h"
#include "core/sensing/face/face_shape.h"

#include <string>
#include <vector>

namespace alltact {

/// Why there is no number.
enum class HardRefusal {
  kOther = 0,  ///< due nowhere
  kTooDark,
  kSaturated,
  kNoContact,
  kNoAngle,     ///< a contact without a long axis
  kNoHit,       ///< a ray misses the ball
  kNoCircle,    ///< points on a line
  kNoDistance,  ///< of a face in a column
  kFoldedLens,
  kUnprovenLens,  ///< undetermined by the views, or not good enough to measure with
};

/// Answer of a formula to one question: numbers, or the reason why there are none.
struct HardAnswer {
  std::vector<double> values;  ///< empty: refused
  HardRefusal refusal = HardRefusal::kOther;
};

struct HardQuestion {
  std::vector<double> truth;  ///< empty: there is no number; the answer must be a refusal ...
  HardRefusal due = HardRefusal::kOther;  ///< ... of this kind
  double scale = 1;                       ///< > 0; unit of the errors: |truth| for relative ones
};

/// Aggregation of the errors |values - truth| / scale of all answers into one figure. It is
/// infinite for numbers that are not finite, too many or too few, and where a due reason is missing
/// or differs. kWrong counts these cases instead.
enum class HardMeasure {
  kWorst = 1,   ///< the greatest
  kRms,         ///< root of their mean square
  kBias,        ///< |mean| of the signed errors of the first value
  kBiasInSd,    ///< the same over their standard deviation
  kSpread,      ///< |root mean square - 1|: scale is the required spread
  kSdAccuracy,  ///< values are (value, sd): |mean of ((value - truth) / sd)^2 - 1|; no error >
                ///< scale
  kWrong,       ///< fraction of all questions with an error above 1, or a bad answer as above
};

/// A list of questions, and the answers of both methods.
struct HardRow {
  std::string what;   ///< "radius of a speck, 1e-12 to 1e-7 rad"
  std::string naive;  ///< the formula or method that fails: "sqrt(1 - cos^2)"
  std::string unit;   ///< of the figure: "relative", "mm", "px", ...
  double bound = 0;   ///< this program must not exceed it
  HardMeasure measure = HardMeasure::kWorst;
  double min_answered = 1;  ///< minimum fraction of answers among questions that have a number
  std::vector<HardQuestion> questions = {};
  std::vector<HardAnswer> naive_answers = {}, own_answers = {};

  void ask(HardQuestion question, HardAnswer naive, HardAnswer own);
};

struct HardScore {
  double error = 0;     ///< infinite where no number can be given
  double answered = 0;  ///< fraction answered of the questions that have a number; 0 when none has
};

/// answers: one for each question of the row.
[[nodiscard]] HardScore score(const HardRow& row, const std::vector<HardAnswer>& answers);

/// A row's figures.
struct HardCase {
  std::string what, naive, unit;  ///< as in HardRow
  HardScore naive_score, own_score;
  double bound = 0, min_answered = 1;

  /// This program's error is a number within the bound, and it answers enough questions.
  [[nodiscard]] bool holds() const { return is_within(own_score); }
  /// The naive formula's error is above the bound, or it answers too few questions.
  [[nodiscard]] bool naive_fails() const { return !is_within(naive_score); }

 private:
  [[nodiscard]] bool is_within(const HardScore& score) const {
    return score.error <= bound && score.answered >= min_answered;
  }
};

/// The row's figures with the answers `own` taken as those of this program.
[[nodiscard]] HardCase judged(const HardRow& row, const std::vector<HardAnswer>& own);

/// Computes all rows, in a few seconds; every random number has a fixed seed.
[[nodiscard]] std::vector<HardRow> hard_rows();

/// The figures of all rows.
[[nodiscard]] std::vector<HardCase> hard_cases();

// The groups that make up hard_rows(), a file each, and their common functions.

[[nodiscard]] std::vector<HardRow> hard_directions();  ///< angles, rays, slopes: in 50 digits
[[nodiscard]] std::vector<HardRow> hard_outlines();    ///< balls and circles from their borders
[[nodiscard]] std::vector<HardRow> hard_faces();       ///< distance from width, edges
[[nodiscard]] std::vector<HardRow> hard_curves();      ///< least squares, mappings
[[nodiscard]] std::vector<HardRow> hard_lenses();      ///< distortion and its inverse
[[nodiscard]] std::vector<HardRow> hard_brightness();  ///< differences, references
[[nodiscard]] std::vector<HardRow> hard_contacts();    ///< angle, direction, markers

/// A rigid flat sensor under a telecentric lens; the face fills the image.
[[nodiscard]] FaceShape flat_sensor(const cv::Size& size, double mm_per_px);

[[nodiscard]] inline HardAnswer number(double value) { return {{value}}; }
[[nodiscard]] inline HardAnswer refused(HardRefusal why = HardRefusal::kOther) { return {{}, why}; }
[[nodiscard]] HardAnswer refused(const Error& error);
/// Answer of a step that gives no reasons: a number, or `why` where there is none.
[[nodiscard]] inline HardAnswer number_or(const std::optional<double>& value, HardRefusal why) {
  return value ? number(*value) : refused(why);
}

/// A question with a number for an answer; `scale` is the unit of errors.
[[nodiscard]] inline HardQuestion expected(double truth, double scale) {
  return {{truth}, {}, scale};
}
/// The same; errors are relative to the truth.
[[nodiscard]] inline HardQuestion expected(double truth) {
  return expected(truth, std::abs(truth));
}
/// A question without an answer; the refusal must be of the kind `due`.
[[nodiscard]] inline HardQuestion expected_refusal(HardRefusal due) { return {{}, due, 1}; }

}  // namespace alltact
