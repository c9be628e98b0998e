// The setting that meets a frame rate and an error limit.
#pragma once

#include "calibration/study/accuracy_study.h"

#include <optional>

namespace alltact {

struct StudyQuestion {
  double frames_per_s = 30;
  /// Of depth, 95 % of pixels; empty: as small as the rate allows.
  std::optional<double> error_mm;

  [[nodiscard]] double budget_ms() const { return 1000 / frames_per_s; }
};

enum class StudyAnswerKind {
  kMostAccurate = 1,  ///< of all within the frame budget
  kErrorMet,          ///< the fastest within the error limit, and within the budget
  kErrorTooSmall,     ///< no setting meets the error limit: the most accurate within the budget
  /// settings within the error limit exceed the budget: the most accurate within it
  kErrorTooSlow,
  kTooSlow,  ///< no setting is within the budget: the fastest of all
};

struct StudyAnswer {
  StudyAnswerKind kind = StudyAnswerKind::kMostAccurate;
  std::size_t row = 0;                      ///< of the study
  std::optional<std::size_t> within_error;  ///< of kErrorTooSlow: the row within the error limit
};

/// nullopt: no row of the study has a depth in all its frames.
[[nodiscard]] std::optional<StudyAnswer> answer_to(const StudyQuestion& question,
                                                   const AccuracyStudy& study);

}  // namespace alltact
