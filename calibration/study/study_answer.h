// Two questions, so many pictures a second and so small an error, answered by one setting.
#pragma once

#include "calibration/study/accuracy_study.h"

#include <optional>

namespace alltact {

struct StudyQuestion {
  double pictures_per_s = 30;
  /// Of depth, 95 % of pixels; absent: as small as fits.
  std::optional<double> error_mm;

  [[nodiscard]] double budget_ms() const { return 1000 / pictures_per_s; }
};

enum class StudyAnswerKind {
  kMostAccurate = 1,  ///< of all that fit
  kKeepsError,        ///< the fastest that keeps the error, and it fits
  kErrorTooSmall,     ///< no setting keeps the error: the most accurate that fits
  kErrorTooSlow,      ///< what keeps the error does not fit: the most accurate that does
  kTooSlow,           ///< nothing fits: the fastest that there is
};

struct StudyAnswer {
  StudyAnswerKind kind = StudyAnswerKind::kMostAccurate;
  std::size_t row = 0;               ///< of the study
  std::optional<std::size_t> keeps;  ///< of kErrorTooSlow: the row that keeps the error
};

/// nullopt: no row of the study has a depth in all its frames.
[[nodiscard]] std::optional<StudyAnswer> answer_to(const StudyQuestion& question,
                                                   const AccuracyStudy& study);

}  // namespace alltact
