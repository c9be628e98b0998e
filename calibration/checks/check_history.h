// The checks of a finger over time: checks.csv in its folder, one line a check.
//
//   time_utc,verdict,error_mm,drifting_above_mm,recalibrate_above_mm,light_percent,presses,
//   ball_radius_mm,calibration_date,program_version,bias_mm,operator
//
// Earlier versions wrote neither bias_mm nor operator; such lines are valid.
#pragma once

#include "calibration/checks/press_check.h"
#include "core/base/result.h"
#include "core/base/utc_time.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct CheckEntry {
  std::string time;  ///< UTC, 2026-01-31T12:00:00Z
  CheckVerdict verdict = CheckVerdict::kPass;
  double error_mm = 0, drifting_above_mm = 0, recalibrate_above_mm = 0;
  double light_percent = 0;
  int presses = 0;
  double ball_radius_mm = 0;
  std::string calibration_date;  ///< of the calibration that was checked
  std::string program_version;
  std::optional<double> bias_mm;  ///< PressCheck::bias_mm; empty: of an earlier version
  std::string operator_name;      ///< empty: not given

  bool operator==(const CheckEntry&) const = default;
};

[[nodiscard]] CheckEntry entry_of(const PressCheck& check, const Finger& finger,
                                  const std::string& time, const std::string& program_version,
                                  const std::string& operator_name);

inline constexpr const char* kCheckFile = "checks.csv";

/// Oldest first; empty without a file. An invalid line is left out and reported in `warnings`.
/// Error: the file exists and cannot be read.
[[nodiscard]] Result<std::vector<CheckEntry>> load_checks(const std::filesystem::path& folder,
                                                          std::vector<Message>* warnings);

/// Its verdict by the current rule: earlier versions passed with any number of presses.
[[nodiscard]] CheckVerdict verdict_now(const CheckEntry& entry);

/// True where the entry belongs to the finger's current calibration. An entry or finger without a
/// date, as in old files, counts as a match.
[[nodiscard]] bool is_of_calibration(const CheckEntry& entry, const Finger& finger);

/// The last entry if it belongs to the finger's current calibration, else null.
[[nodiscard]] const CheckEntry* latest_check(const std::vector<CheckEntry>& history,
                                             const Finger& finger);

/// Appends a line to the file, atomically; other content stays.
[[nodiscard]] Status append_check(const std::filesystem::path& folder, const CheckEntry& entry);

}  // namespace alltact
