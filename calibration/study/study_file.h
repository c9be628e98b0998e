// A study as text, table and JSON.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "calibration/study/study_front.h"
#include "core/result.h"

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

/// One row on one line, in the form that a resumed study reads.
[[nodiscard]] std::string line_of(const StudyRow& row);
/// Error: a malformed line; a truncated last line is ignored.
[[nodiscard]] Result<std::vector<StudyRow>> rows_of_lines(std::string_view lines,
                                                          const std::string& where);

/// The study for other programs: errors apart from times, which depend on the computer.
[[nodiscard]] nlohmann::json json_of(const AccuracyStudy& study);

/// A line a row, with a header line: for spreadsheets.
[[nodiscard]] std::string csv_of(const AccuracyStudy& study);

/// The front and the rows that change one setting, in columns for a terminal.
[[nodiscard]] std::string text_of(const AccuracyStudy& study);

}  // namespace alltact
