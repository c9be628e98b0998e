// The settings that a study recommends.
#pragma once

#include "calibration/finger/measuring_presets.h"
#include "calibration/study/accuracy_study.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Time of a row on this computer, ms: the base's own time multiplied by the row's ratio to the
/// base. The ratio does not depend on the computer's load during the measurement.
[[nodiscard]] double frame_ms(const AccuracyStudy& study, const StudyRow& row);

/// Acceptable position error of a row, mm: a quarter more than the base's, at least 0.01 mm.
/// nullopt: the base has no position, so that there is no limit.
[[nodiscard]] std::optional<double> default_position_limit_mm(const AccuracyStudy& study);

/// 95 % bound of a row's depth error, mm, including the mapping's own error
/// (AccuracyStudy::mapping_p95_mm; independent errors). nullopt: no depth, or frames without depth.
[[nodiscard]] std::optional<double> error_p95_mm(const AccuracyStudy& study, const StudyRow& row);

/// 95 % bound of a row's frame time, computed as in frame_ms().
[[nodiscard]] double frame_p95_ms(const AccuracyStudy& study, const StudyRow& row);

/// Rows (by index, fastest first) that no other row dominates: none is at most as slow and at most
/// as wrong in depth and position (medians), and better in one of them. Rows without depth are
/// excluded; a row without a position ranks behind any with one. Rows that are not proven
/// (is_proven()) are excluded here and from all selections below.
[[nodiscard]] std::vector<std::size_t> pareto_front(const AccuracyStudy& study);

/// A row of the front that is better than this one in all three: the one with the smallest depth
/// error. nullopt: it is on the front, or has no depth.
[[nodiscard]] std::optional<std::size_t> dominated_by(const AccuracyStudy& study,
                                                      const std::vector<std::size_t>& front,
                                                      std::size_t row);

/// The row with the smallest median depth error among those within the time budget and the limit of
/// the median position error. nullopt: none is.
///   position_mm: empty: default_position_limit_mm()
[[nodiscard]] std::optional<std::size_t> most_accurate_within(
    const AccuracyStudy& study, double budget_ms, std::optional<double> position_mm = {});

/// The fastest row whose 95 % error (error_p95_mm) is within error_mm and whose position error is
/// within the limit as above. nullopt: none is.
[[nodiscard]] std::optional<std::size_t> fastest_within(const AccuracyStudy& study, double error_mm,
                                                        std::optional<double> position_mm = {});

/// Losses and gains of a row against the base, each a phrase with its figures. Counted are times
/// that differ by more than 2 %, errors by more than 5 % and 1 micrometre (0.1 degrees).
struct StudyBalance {
  std::vector<Message> loses, brings;
};
[[nodiscard]] StudyBalance balance_of(const AccuracyStudy& study, const StudyRow& row);

/// Named settings, where they improve something on this finger and stay within the position limit.
struct StudyPresets {
  /// least time; error at most 1.5 times the base's, at least 10 % faster
  std::optional<std::size_t> fast;
  ///< at least a tenth faster
  std::size_t balanced = 0;           ///< the base
  std::optional<std::size_t> finest;  ///< least error, at least 3 % below the base's
};
[[nodiscard]] StudyPresets presets_of(const AccuracyStudy& study);

// The setting that meets a frame rate and an error limit.

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

// The presets of a study, in the form that a finger stores.

/// The study's presets (presets_of), for save_presets(): balanced always, fast and finest where
/// they improve something. The study's base counts as the calibration's settings.
///   machine: processor and number of threads, for people
[[nodiscard]] MeasuringPresets presets_to_save(const AccuracyStudy& study,
                                               const std::string& machine);

}  // namespace alltact
