// What a finger is worth now, from its folder: the verdict on its calibration, its files, its last
// check, and what is due. Window, cards, command line, exports and stream take their words from
// here.
#pragma once

#include "calibration/checks/check_history.h"
#include "calibration/finger/finger_evidence.h"
#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// The last check of the calibration that the finger has now; a pass with too few presses, which
/// earlier versions gave, is none.
[[nodiscard]] std::optional<CheckEntry> last_check(const FingerSnapshot& snapshot);

struct FingerWorth {
  std::optional<CalibrationEvidence> evidence;  ///< of the verdict
  std::optional<Verdict> verdict;  ///< absent: not calibrated, or nothing is stored of how
  ReferenceState reference = ReferenceState::kAbsent;
  bool must_repeat = false;         ///< numbers or reference changed since the calibration
  std::optional<CheckEntry> check;  ///< the last of this calibration
  FingerDue due = FingerDue::kNothing;
};
[[nodiscard]] FingerWorth worth_of(const FingerSnapshot& snapshot, const std::string& now);

}  // namespace alltact
