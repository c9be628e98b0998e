#include "calibration/study/recommended_settings.h"

#include "core/base/program.h"
#include "core/base/utc_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kFastMaxError = 1.5;     // times the base's error
constexpr double kFastMaxTime = 0.9;      // of the base's time
constexpr double kFinestMaxError = 0.97;  // of the base's error
constexpr double kNever = std::numeric_limits<double>::infinity();

double median_error_mm(const StudyRow& row) {
  if (!row.depth || row.frames_missing != 0) return kNever;
  return row.depth->median_mm;
}

double position_error_mm(const StudyRow& row) { return row.position_mm.value_or(kNever); }

bool is_better(const AccuracyStudy& study, const StudyRow& a, const StudyRow& b) {
  const std::array<double, 3> of_a{frame_ms(study, a), median_error_mm(a), position_error_mm(a)};
  const std::array<double, 3> of_b{frame_ms(study, b), median_error_mm(b), position_error_mm(b)};
  bool is_less = false;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (of_a[i] > of_b[i]) return false;
    is_less = is_less || of_a[i] < of_b[i];
  }
  return is_less;
}

/// A row that may be chosen.
bool is_eligible(const AccuracyStudy& study, const StudyRow& row) {
  return median_error_mm(row) != kNever && is_proven(row.settings, study.rows.front().settings);
}

bool is_position_within(const StudyRow& row, const std::optional<double>& limit_mm) {
  return !limit_mm || position_error_mm(row) <= *limit_mm;
}

/// One figure of a row and of the base.
struct Compared {
  Message (*describe)(double now, double before);
  std::optional<double> now, before;
  double least;  // smallest difference that is listed
};

void add_to_balance(const Compared& figure, StudyBalance& balance) {
  constexpr double kLeastPart = 0.05;
  if (!figure.now || !figure.before) return;
  const double more = *figure.now - *figure.before;
  if (std::abs(more) <= std::max(figure.least, kLeastPart * *figure.before)) return;
  (more > 0 ? balance.loses : balance.brings)
      .push_back(figure.describe(*figure.now, *figure.before));
}

}  // namespace

double frame_ms(const AccuracyStudy& study, const StudyRow& row) {
  return study.rows.front().time_ms * row.time_ratio;
}

double frame_p95_ms(const AccuracyStudy& study, const StudyRow& row) {
  return row.time_ms > 0 ? frame_ms(study, row) * row.time_p95_ms / row.time_ms : row.time_p95_ms;
}

std::vector<std::size_t> pareto_front(const AccuracyStudy& study) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const StudyRow& row = study.rows[i];
    if (!is_eligible(study, row)) continue;
    const bool is_dominated =
        std::any_of(study.rows.begin(), study.rows.end(), [&](const StudyRow& other) {
          return is_eligible(study, other) && is_better(study, other, row);
        });
    if (!is_dominated) front.push_back(i);
  }
  std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return frame_ms(study, study.rows[a]) < frame_ms(study, study.rows[b]);
  });
  return front;
}

std::optional<double> default_position_limit_mm(const AccuracyStudy& study) {
  constexpr double kPart = 1.25, kLeastMm = 0.01;
  const auto& base_mm = study.rows.front().position_mm;
  if (!base_mm) return std::nullopt;
  return std::max(kPart * *base_mm, *base_mm + kLeastMm);
}

std::optional<double> error_p95_mm(const AccuracyStudy& study, const StudyRow& row) {
  if (median_error_mm(row) == kNever) return std::nullopt;
  return std::hypot(row.depth->p95_mm, study.mapping_p95_mm);
}

std::optional<std::size_t> dominated_by(const AccuracyStudy& study,
                                        const std::vector<std::size_t>& front, std::size_t row) {
  if (median_error_mm(study.rows[row]) == kNever) return std::nullopt;
  std::optional<std::size_t> best;
  for (const std::size_t other : front)
    if (is_better(study, study.rows[other], study.rows[row]) &&
        (!best || median_error_mm(study.rows[other]) < median_error_mm(study.rows[*best])))
      best = other;
  return best;
}

std::optional<std::size_t> most_accurate_within(const AccuracyStudy& study, double budget_ms,
                                                std::optional<double> position_mm) {
  if (!position_mm) position_mm = default_position_limit_mm(study);
  std::optional<std::size_t> best;
  for (const std::size_t i : pareto_front(study)) {
    const StudyRow& row = study.rows[i];
    if (frame_ms(study, row) > budget_ms || !is_position_within(row, position_mm)) continue;
    if (!best || median_error_mm(row) < median_error_mm(study.rows[*best])) best = i;
  }
  return best;
}

std::optional<std::size_t> fastest_within(const AccuracyStudy& study, double error_mm,
                                          std::optional<double> position_mm) {
  if (!position_mm) position_mm = default_position_limit_mm(study);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const StudyRow& row = study.rows[i];
    const auto row_p95_mm = error_p95_mm(study, row);
    if (!is_eligible(study, row) || !row_p95_mm || *row_p95_mm > error_mm ||
        !is_position_within(row, position_mm))
      continue;
    if (!best || frame_ms(study, row) < frame_ms(study, study.rows[*best])) best = i;
  }
  return best;
}

StudyBalance balance_of(const AccuracyStudy& study, const StudyRow& row) {
  constexpr double kLeastMm = 0.001, kLeastDeg = 0.1;
  const StudyRow& base = study.rows.front();
  const auto median = [](const StudyRow& of) {
    return of.depth ? std::optional(of.depth->median_mm) : std::nullopt;
  };
  const auto p95 = [](const StudyRow& of) {
    return of.depth ? std::optional(of.depth->p95_mm) : std::nullopt;
  };
  StudyBalance balance;
  const double ratio = row.time_ratio / base.time_ratio;
  if (ratio > 1.02) balance.loses.push_back(en::say("takes {:.2f} times as long", ratio));
  if (ratio < 0.98) balance.brings.push_back(en::say("takes {:.2f} times as long", ratio));
  for (const Compared& figure :
       {Compared{[](double now, double before) {
                   return en::say("depth error {:.1f} instead of {:.1f} micrometres", 1000 * now,
                                  1000 * before);
                 },
                 median(row), median(base), kLeastMm},
        Compared{[](double now, double before) {
                   return en::say("95 % of depth within {:.1f} instead of {:.1f} micrometres",
                                  1000 * now, 1000 * before);
                 },
                 p95(row), p95(base), kLeastMm},
        Compared{[](double now, double before) {
                   return en::say("position error {:.3f} instead of {:.3f} mm", now, before);
                 },
                 row.position_mm, base.position_mm, kLeastMm},
        Compared{[](double now, double before) {
                   return en::say("angle error {:.1f} instead of {:.1f} degrees", now, before);
                 },
                 row.angle_deg, base.angle_deg, kLeastDeg},
        Compared{[](double now, double before) {
                   return en::say("{:.1f} instead of {:.1f} micrometres of false depth", 1000 * now,
                                  1000 * before);
                 },
                 row.false_depth_mm, base.false_depth_mm, kLeastMm}})
    add_to_balance(figure, balance);
  const int missing = row.frames_missing - base.frames_missing;
  if (missing > 0)
    balance.loses.push_back(en::count("no depth in {} images", "no depth in {} image", missing));
  return balance;
}

StudyPresets presets_of(const AccuracyStudy& study) {
  StudyPresets presets;
  const StudyRow& base = study.rows.front();
  const double base_error = median_error_mm(base);
  const auto limit_mm = default_position_limit_mm(study);
  for (const std::size_t i : pareto_front(study)) {
    const StudyRow& row = study.rows[i];
    if (!is_position_within(row, limit_mm)) continue;
    if (!presets.fast && median_error_mm(row) <= kFastMaxError * base_error) presets.fast = i;
    if (!presets.finest || median_error_mm(row) < median_error_mm(study.rows[*presets.finest]))
      presets.finest = i;
  }
  if (presets.fast && study.rows[*presets.fast].time_ratio > kFastMaxTime) presets.fast.reset();
  if (presets.finest && median_error_mm(study.rows[*presets.finest]) > kFinestMaxError * base_error)
    presets.finest.reset();
  return presets;
}

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

MeasuringPresets presets_to_save(const AccuracyStudy& study, const std::string& machine) {
  MeasuringPresets saved;
  saved.date = utc_now();
  saved.program_version = program_version();
  saved.machine = machine;
  saved.about = fmt::format("{}, {} pictures", study.about.english(), study.rows.front().frames);
  saved.calibrated = saved.now = study.rows.front().settings;
  const StudyPresets found = presets_of(study);
  const auto add = [&](const char* name, std::optional<std::size_t> number) {
    if (!number) return;
    const StudyRow& row = study.rows[*number];
    if (!row.depth) return;
    saved.presets.push_back(
        {name, row.settings, frame_ms(study, row), row.depth->median_mm, row.depth->p95_mm});
  };
  add("fast", found.fast);
  add("balanced", found.balanced);
  add("finest", found.finest);
  return saved;
}

}  // namespace alltact
