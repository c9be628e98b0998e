// The checks of a finger over time: checks.csv in its folder, one line a check.
//
//   time_utc,verdict,error_mm,drifting_above_mm,recalibrate_above_mm,light_percent,presses,
//   ball_radius_mm,calibration_date,program_version
#pragma once

#include "calibration/checks/press_check.h"
#include "core/result.h"
#include "core/utc_time.h"

#include <filesystem>
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

  bool operator==(const CheckEntry&) const = default;
};

[[nodiscard]] CheckEntry entry_of(const PressCheck& check,
                                  const Finger& finger,
                                  const std::string& time,
                                  const std::string& program_version);

inline constexpr const char* kCheckFile = "checks.csv";

/// Oldest first; empty where there is no file. A line that is no check is left out and named in
/// `warnings`. Error: the file is there and cannot be read.
[[nodiscard]] Result<std::vector<CheckEntry>> load_checks(const std::filesystem::path& folder,
                                                          std::vector<Message>* warnings);

/// Its verdict by what a pass needs now: earlier versions passed with any number of presses.
[[nodiscard]] CheckVerdict verdict_now(const CheckEntry& entry);

/// The last of them where it is of the calibration that the finger has now, else null. Where either
/// does not tell its date, as old files do not, it is taken for one of this calibration.
[[nodiscard]] const CheckEntry* latest_check(const std::vector<CheckEntry>& history,
                                             const Finger& finger);

/// Adds a line to the file, whole or not at all; whatever else stands in it stays.
[[nodiscard]] Status append_check(const std::filesystem::path& folder, const CheckEntry& entry);

}  // namespace alltact
