#include "calibration/study/study_front.h"

#include <algorithm>
#include <limits>

namespace alltact {
namespace {

constexpr double kFastIsAtMost = 1.5;     // times the base's error
constexpr double kFastTakesAtMost = 0.9;  // of the base's time
constexpr double kFinestIsAtMost = 0.97;  // of the base's error
constexpr double kNever = std::numeric_limits<double>::infinity();

double median_error_mm(const StudyRow& row) {
  return row.depth && row.frames_missing == 0 ? row.depth->median_mm : kNever;
}

bool is_better(const AccuracyStudy& study, const StudyRow& a, const StudyRow& b) {
  const double time_a = frame_ms(study, a), time_b = frame_ms(study, b);
  const double error_a = median_error_mm(a), error_b = median_error_mm(b);
  return time_a <= time_b && error_a <= error_b && (time_a < time_b || error_a < error_b);
}

}  // namespace

double frame_ms(const AccuracyStudy& study, const StudyRow& row) {
  return study.rows.front().time_ms * row.time_ratio;
}

std::vector<std::size_t> pareto_front(const AccuracyStudy& study) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const StudyRow& row = study.rows[i];
    if (median_error_mm(row) == kNever) continue;
    const bool is_dominated =
        std::any_of(study.rows.begin(), study.rows.end(), [&](const StudyRow& other) {
          return is_better(study, other, row);
        });
    if (!is_dominated) front.push_back(i);
  }
  std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return frame_ms(study, study.rows[a]) < frame_ms(study, study.rows[b]);
  });
  return front;
}

std::optional<std::size_t> dominated_by(const AccuracyStudy& study,
                                        const std::vector<std::size_t>& front,
                                        std::size_t row) {
  if (median_error_mm(study.rows[row]) == kNever) return std::nullopt;
  std::optional<std::size_t> best;
  for (const std::size_t other : front)
    if (is_better(study, study.rows[other], study.rows[row])) best = other;
  return best;  // errors fall along the front
}

std::optional<std::size_t> as_good_as_fits(const AccuracyStudy& study, double budget_ms) {
  std::optional<std::size_t> best;
  for (const std::size_t row : pareto_front(study))
    if (frame_ms(study, study.rows[row]) <= budget_ms) best = row;
  return best;
}

std::optional<std::size_t> as_fast_as_keeps(const AccuracyStudy& study, double error_mm) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const StudyRow& row = study.rows[i];
    if (median_error_mm(row) == kNever || row.depth->p95_mm > error_mm) continue;
    if (!best || frame_ms(study, row) < frame_ms(study, study.rows[*best])) best = i;
  }
  return best;
}

StudyPresets presets_of(const AccuracyStudy& study) {
  StudyPresets presets;
  const StudyRow& base = study.rows.front();
  const double base_error = median_error_mm(base);
  const std::vector<std::size_t> front = pareto_front(study);
  const auto fast = std::find_if(front.begin(), front.end(), [&](std::size_t i) {
    return median_error_mm(study.rows[i]) <= kFastIsAtMost * base_error;
  });
  if (fast != front.end() && study.rows[*fast].time_ratio <= kFastTakesAtMost) presets.fast = *fast;
  if (!front.empty() && median_error_mm(study.rows[front.back()]) <= kFinestIsAtMost * base_error)
    presets.finest = front.back();
  return presets;
}

}  // namespace alltact
