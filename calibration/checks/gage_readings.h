// Readings of a gage study: from a table, or from the checks of several fingers.
#pragma once

#include "calibration/checks/gage_study.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

struct GageReadings {
  std::vector<GageReading> readings;  ///< mm, less `origin_mm`
  /// Subtracted from all values in exact decimals: a table of large numbers that differ in the last
  /// digits loses none.
  double origin_mm = 0;
  std::vector<Message> remarks;  ///< what was left out, and why
};

/// A table (core/base/table.h) with the columns
///   part       also "finger", "sample", "specimen": what was measured
///   operator   also "appraiser", "person", "technician"; absent: one operator
///   value_mm   also "value", "reading", "measurement"
/// Errors: those of Table; a missing column or cell; no rows.
[[nodiscard]] Result<GageReadings> read_gage_table(const std::filesystem::path& file);

/// The checks with presses of each finger's current calibration: its reading is the mean bias of
/// the depth, mm, by the operator who was named. Checks without one are left out. The last ones
/// count, as many of each finger and operator. Errors: a finger that is named twice; a folder that
/// is no finger; no check with an operator; stopped.
[[nodiscard]] Result<GageReadings> read_gage_checks(
    const std::vector<std::filesystem::path>& fingers, const Job& job);

}  // namespace alltact
