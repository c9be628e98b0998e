#include "calibration/study/study_answer.h"

#include "calibration/study/study_front.h"

#include <limits>

namespace alltact {

std::optional<StudyAnswer> answer_to(const StudyQuestion& question, const AccuracyStudy& study) {
  const std::vector<std::size_t> front = pareto_front(study);
  if (front.empty()) return std::nullopt;
  const auto fits = as_good_as_fits(study, question.budget_ms());
  if (!fits) {
    const auto fastest = as_fast_as_keeps(study, std::numeric_limits<double>::infinity());
    return StudyAnswer{StudyAnswerKind::kTooSlow, fastest.value_or(front.front()), {}};
  }
  if (!question.error_mm) return StudyAnswer{StudyAnswerKind::kMostAccurate, *fits, {}};
  const auto keeps = as_fast_as_keeps(study, *question.error_mm);
  if (!keeps) return StudyAnswer{StudyAnswerKind::kErrorTooSmall, *fits, {}};
  if (frame_ms(study, study.rows[*keeps]) > question.budget_ms())
    return StudyAnswer{StudyAnswerKind::kErrorTooSlow, *fits, keeps};
  return StudyAnswer{StudyAnswerKind::kKeepsError, *keeps, {}};
}

}  // namespace alltact
