#include "calibration/study/study_answer.h"

#include "calibration/study/study_front.h"

#include <limits>

namespace alltact {

std::optional<StudyAnswer> answer_to(const StudyQuestion& question, const AccuracyStudy& study) {
  const std::vector<std::size_t> front = pareto_front(study);
  if (front.empty()) return std::nullopt;
  const auto fits = most_accurate_within(study, question.budget_ms());
  if (!fits) {
    const auto fastest = fastest_within(study, std::numeric_limits<double>::infinity());
    return StudyAnswer{StudyAnswerKind::kTooSlow, fastest.value_or(front.front()), {}};
  }
  if (!question.error_mm) return StudyAnswer{StudyAnswerKind::kMostAccurate, *fits, {}};
  const auto within_error = fastest_within(study, *question.error_mm);
  if (!within_error) return StudyAnswer{StudyAnswerKind::kErrorTooSmall, *fits, {}};
  if (frame_ms(study, study.rows[*within_error]) > question.budget_ms())
    return StudyAnswer{StudyAnswerKind::kErrorTooSlow, *fits, within_error};
  return StudyAnswer{StudyAnswerKind::kErrorMet, *within_error, {}};
}

}  // namespace alltact
