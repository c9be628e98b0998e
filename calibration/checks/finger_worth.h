// The current state of a finger, from its folder: the verdict on its calibration, its files, its
// last check, and what is due. Window, cards, command line, exports and stream use these texts.
#pragma once

#include "calibration/checks/check_history.h"
#include "calibration/finger/finger_evidence.h"
#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// The last check of the finger's current calibration. A pass with too few presses, which earlier
/// versions gave, counts as none.
[[nodiscard]] std::optional<CheckEntry> last_check(const FingerSnapshot& snapshot);

struct FingerWorth {
  std::optional<CalibrationEvidence> evidence;  ///< of the verdict
  /// empty: not calibrated, or without a record of the calibration
  std::optional<Verdict> verdict;
  ReferenceState reference = ReferenceState::kAbsent;
  bool must_repeat = false;         ///< numbers or reference changed since the calibration
  std::optional<CheckEntry> check;  ///< the last one of this calibration
  FingerDue due = FingerDue::kNothing;
};
[[nodiscard]] FingerWorth worth_of(const FingerSnapshot& snapshot, const std::string& now);

}  // namespace alltact
