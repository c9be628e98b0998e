// calibration_report.json: what a calibration came to, for other programs.
#pragma once

#include "calibration/finger/calibrate_finger.h"

#include <string>

namespace alltact {

inline constexpr const char* kReportFigures = "calibration_report.json";
inline constexpr const char* kReportPage = "calibration_report.html";
inline constexpr const char* kReportPaper = "calibration_report.pdf";

/// The whole content of the file: `format` alltact-calibration-report/1, lengths in mm. The same
/// calibration gives the same bytes; the date stands in finger.yaml and the inputs only. `said`
/// holds sentences by their templates, for recall_calibration().
[[nodiscard]] std::string calibration_report_json(const FingerCalibration& done);

/// The command that makes this calibration again, for a shell in the folder above the finger's.
[[nodiscard]] std::string repeat_command(const std::filesystem::path& finger_folder);

/// The whole command that does what calibrate_finger() does with `input`, report and all, for any
/// shell: paths are absolute.
[[nodiscard]] std::string calibrate_command(const FingerCalibrationInput& input);

}  // namespace alltact
