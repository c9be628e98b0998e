// What a study says about which settings to take.
#pragma once

#include "calibration/study/accuracy_study.h"

#include <optional>
#include <vector>

namespace alltact {

/// Time of a row on this computer, ms: the base's own times its ratio to the base, which does not
/// hang on what else the computer did while this row was measured.
[[nodiscard]] double frame_ms(const AccuracyStudy& study, const StudyRow& row);

/// Rows (by index, fastest first) that no other is better than: nothing is at most as slow and at
/// most as wrong (median of depth), and less in one of both. Rows without depth are never among
/// them.
[[nodiscard]] std::vector<std::size_t> pareto_front(const AccuracyStudy& study);

/// A row of the front that is better than this one in both: the most accurate of those. nullopt: it
/// is on the front, or has no depth.
[[nodiscard]] std::optional<std::size_t> dominated_by(const AccuracyStudy& study,
                                                      const std::vector<std::size_t>& front,
                                                      std::size_t row);

/// The most accurate row (median of depth) that takes at most so long. nullopt: none does.
[[nodiscard]] std::optional<std::size_t> as_good_as_fits(const AccuracyStudy& study,
                                                         double budget_ms);

/// The fastest row of whose pixels 95 % are at most so wrong. nullopt: none is.
[[nodiscard]] std::optional<std::size_t> as_fast_as_keeps(const AccuracyStudy& study,
                                                          double error_mm);

/// Settings with a name of their own, where they bring something on this finger.
struct StudyPresets {
  std::optional<std::size_t> fast;    ///< least time, at most half as wrong again as the base, and
                                      ///< at least a tenth faster
  std::size_t balanced = 0;           ///< the base
  std::optional<std::size_t> finest;  ///< least error, by at least 3 % of the base's
};
[[nodiscard]] StudyPresets presets_of(const AccuracyStudy& study);

}  // namespace alltact
