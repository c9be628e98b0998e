// What a study says about which settings to take.
#pragma once

#include "calibration/study/accuracy_study.h"

#include <optional>
#include <vector>

namespace alltact {

/// Time of a row on this computer, ms: the base's own times its ratio to the base, which does not
/// hang on what else the computer did while this row was measured.
[[nodiscard]] double frame_ms(const AccuracyStudy& study, const StudyRow& row);

/// Error of a row's place that still counts as keeping it: a quarter more than the base's, and a
/// hundredth of a millimetre at least. nullopt: the base tells no place, and nothing can lose it.
[[nodiscard]] std::optional<double> usual_place_limit_mm(const AccuracyStudy& study);

/// What 95 % of a row's depths are within, with what the mapping is wrong by besides (
/// AccuracyStudy::mapping_p95_mm; independent errors). nullopt: no depth, or frames without.
[[nodiscard]] std::optional<double> kept_error_mm(const AccuracyStudy& study, const StudyRow& row);

/// 95 % of a row's frames take at most so long, on the same footing as frame_ms().
[[nodiscard]] double frame_p95_ms(const AccuracyStudy& study, const StudyRow& row);

/// Rows (by index, fastest first) that no other is better than: nothing is at most as slow, at most
/// as wrong in depth (median) and in place (median), and less in one of these. Rows without depth
/// are never among them; a row without a place is worse than any with one. Rows that are not proven
/// (is_proven()) take no part, and are never chosen by what follows.
[[nodiscard]] std::vector<std::size_t> pareto_front(const AccuracyStudy& study);

/// A row of the front that is better than this one in all three: that with the least error of
/// depth. nullopt: it is on the front, or has no depth.
[[nodiscard]] std::optional<std::size_t> dominated_by(const AccuracyStudy& study,
                                                      const std::vector<std::size_t>& front,
                                                      std::size_t row);

/// The row with the least error of depth (median) of those that take at most so long and whose
/// place (median) is at most so wrong. nullopt: none is.
///   place_mm: absent: usual_place_limit_mm()
[[nodiscard]] std::optional<std::size_t> as_good_as_fits(const AccuracyStudy& study,
                                                         double budget_ms,
                                                         std::optional<double> place_mm = {});

/// The fastest row of whose pixels 95 % are at most so wrong (kept_error_mm) and that keeps its
/// place as above. nullopt: none is.
[[nodiscard]] std::optional<std::size_t> as_fast_as_keeps(const AccuracyStudy& study,
                                                          double error_mm,
                                                          std::optional<double> place_mm = {});

/// What a row loses against the base, and what it brings, each in a phrase with its figures: time
/// by more than 2 %, errors by more than 5 % and 1 micrometre (0.1 degrees).
struct StudyBalance {
  std::vector<Message> loses, brings;
};
[[nodiscard]] StudyBalance balance_of(const AccuracyStudy& study, const StudyRow& row);

/// Settings with a name of their own, where they bring something on this finger and keep the place.
struct StudyPresets {
  std::optional<std::size_t> fast;    ///< least time, at most half as wrong again as the base, and
                                      ///< at least a tenth faster
  std::size_t balanced = 0;           ///< the base
  std::optional<std::size_t> finest;  ///< least error, by at least 3 % of the base's
};
[[nodiscard]] StudyPresets presets_of(const AccuracyStudy& study);

}  // namespace alltact
