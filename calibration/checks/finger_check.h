// Checks whether a finger is fit to use: what is missing, stale or weak.
#pragma once

#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/message.h"

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
[[nodiscard]] FingerCheck check_finger(const FingerSnapshot& snapshot,
                                       const Job& job,
                                       const std::string& now = {});

}  // namespace alltact
