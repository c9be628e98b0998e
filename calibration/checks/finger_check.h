// State of a finger: whether it is fit to use, its verdict, its last check, and what is due.
#pragma once

#include "calibration/checks/check_history.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/verdict/verdict.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/finger/finger_store.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

enum class CheckState {
  kFine = 1,
  kWeak,     ///< works, with limits
  kStale,    ///< works, but something newer contradicts it
  kMissing,  ///< does not work without it
};
[[nodiscard]] std::string_view to_string(CheckState state);

struct CheckItem {
  std::string what;  ///< "reference", "mapping", ...
  CheckState state = CheckState::kFine;
  Message sentence;
};

struct FingerCheck {
  std::vector<CheckItem> items;
  bool fit = false;  ///< nothing is missing, and the mapping can be used to measure
  /// empty: not calibrated, or without a record of the calibration
  std::optional<Verdict> verdict;
};

/// Checks everything a finger needs to measure, and reads the reference recording.
///   now: UTC, as utc_now() writes it; empty: ages do not count
[[nodiscard]] FingerCheck check_finger(const FingerSnapshot& snapshot, const Job& job,
                                       const std::string& now = {});

// The current state of a finger, from its folder: the verdict on its calibration, its files, its
// last check, and what is due. Window, cards, command line, exports and stream use these texts.

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
