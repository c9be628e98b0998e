// What a finger is worth now, from its folder: the verdict on its calibration, its files, its last
// check, and what is due. Window, cards, command line, exports and stream take their words from
// here.
#pragma once

#include "calibration/checks/check_history.h"
#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Whether the files of a finger's reference are there, whole, and of its camera's image size.
/// Decodes one frame at most: some milliseconds, and nothing is written.
[[nodiscard]] ReferenceState reference_state(const FingerSnapshot& snapshot);

/// evidence_of() with what the folder adds: the reference's files, the age of calibration and
/// checks, and how to calibrate again.
///   now: UTC, as utc_now() writes it; empty: ages are unknown
[[nodiscard]] CalibrationEvidence evidence_in(const FingerSnapshot& snapshot,
                                              const std::string& now);

struct FingerState {
  std::optional<Verdict> verdict;  ///< absent: not calibrated, or nothing is stored of how
  ReferenceState reference = ReferenceState::kAbsent;
  bool must_repeat = false;         ///< numbers or reference changed since the calibration
  std::optional<CheckEntry> check;  ///< the last of this calibration
  FingerDue due = FingerDue::kNothing;
};
[[nodiscard]] FingerState state_of(const FingerSnapshot& snapshot, const std::string& now);

}  // namespace alltact
