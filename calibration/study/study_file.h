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

/// One row on one line, as a study that goes on later reads it.
[[nodiscard]] std::string line_of(const StudyRow& row);
/// Error: not such a line; a last line that was cut off is left out.
[[nodiscard]] Result<std::vector<StudyRow>> rows_of_lines(std::string_view lines,
                                                          const std::string& where);

/// What the study says, to be read by programs: errors apart from times, which hang on the
/// computer.
[[nodiscard]] nlohmann::json json_of(const AccuracyStudy& study);

/// A line a row, with a headline: for spreadsheets.
[[nodiscard]] std::string csv_of(const AccuracyStudy& study);

/// The front and the rows that one setting alone makes, in columns for a terminal.
[[nodiscard]] std::string text_of(const AccuracyStudy& study);

}  // namespace alltact
