// calibration_report.json: the result of a calibration, for other programs.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

inline constexpr const char* kReportJson = "calibration_report.json";
inline constexpr const char* kReportHtml = "calibration_report.html";
inline constexpr const char* kReportPdf = "calibration_report.pdf";

/// The full content of the file: `format` alltact-calibration-report/1, lengths in mm. The same
/// calibration gives the same bytes; the date is only in finger.yaml and the inputs. It also
/// holds sentences by their templates. This program does not read it (calibration_file.h).
[[nodiscard]] std::string calibration_report_json(const FingerCalibration& done);

/// The command that repeats this calibration, for a shell in the folder above the finger's.
[[nodiscard]] std::string repeat_command(const std::filesystem::path& finger_folder);

/// The full command for calibrate_finger() with `input`, including reports, for any shell: paths
/// are absolute.
[[nodiscard]] std::string calibrate_command(const FingerCalibrationInput& input);

// The evidence for a finger's verdict, from its folder as it is now.

/// Checks that the files of a finger's reference exist, are complete, and have its camera's image
/// size. Decodes one frame at most, and nothing while the files are unchanged; writes nothing.
[[nodiscard]] ReferenceState reference_state(const FingerSnapshot& snapshot);

/// evidence_of() plus the folder's evidence: the reference's files, the calibration's age, and the
/// command of a repetition.
///   now: UTC, as utc_now() writes it; empty: ages are unknown
///   passed: time of the last passed check of this calibration, likewise; empty: none
[[nodiscard]] CalibrationEvidence evidence_in(const FingerSnapshot& snapshot,
                                              const std::string& now,
                                              const std::string& passed = {});

/// Days between two such times; nullopt where one is invalid.
[[nodiscard]] std::optional<double> days_between(const std::string& then, const std::string& now);

// A verdict for other programs. For .cpp files only.

/// {"grade": "good", "expected_error_mm": 0.021, "causes_mm": {"scale": 0.018, ...}, "missing":
/// [{"evidence": "thirds", "sentence": "..."}], "rests_on": "...", "sentence": "..."}. An unknown
/// error is null.
[[nodiscard]] nlohmann::ordered_json verdict_json(const Verdict& verdict);

/// {"two_points_mm": 0.98, "wall_mm": .., "pin_mm": .., "step_mm": .., "waves_per_mm": [..],
/// "contrasts": [..], "presses": [{"press": .., "along_mm": .., "across_mm": .., ..}], "sentence":
/// ".."}, the worst of all presses first. Null without presses.
[[nodiscard]] nlohmann::ordered_json resolution_json(const FingerCalibration& done);

}  // namespace alltact
