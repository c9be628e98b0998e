// calibration_report.json: the result of a calibration, for other programs.
#pragma once

#include "calibration/finger/calibrate_finger.h"

#include <string>

namespace alltact {

inline constexpr const char* kReportJson = "calibration_report.json";
inline constexpr const char* kReportHtml = "calibration_report.html";
inline constexpr const char* kReportPdf = "calibration_report.pdf";

/// The full content of the file: `format` alltact-calibration-report/1, lengths in mm. The same
/// calibration gives the same bytes; the date is only in finger.yaml and the inputs. It also
/// holds sentences by their templates, for recall_calibration().
[[nodiscard]] std::string calibration_report_json(const FingerCalibration& done);

/// The command that repeats this calibration, for a shell in the folder above the finger's.
[[nodiscard]] std::string repeat_command(const std::filesystem::path& finger_folder);

/// The full command for calibrate_finger() with `input`, including reports, for any shell: paths
/// are absolute.
[[nodiscard]] std::string calibrate_command(const FingerCalibrationInput& input);

}  // namespace alltact
