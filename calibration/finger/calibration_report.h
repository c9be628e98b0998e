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
/// holds sentences by their templates, for recall_calibration().
[[nodiscard]] std::string calibration_report_json(const FingerCalibration& done);

/// The command that repeats this calibration, for a shell in the folder above the finger's.
[[nodiscard]] std::string repeat_command(const std::filesystem::path& finger_folder);

/// The full command for calibrate_finger() with `input`, including reports, for any shell: paths
/// are absolute.
[[nodiscard]] std::string calibrate_command(const FingerCalibrationInput& input);

// Reloads the result of a calibration from a finger's files, without solving.

/// Fast, from finger.yaml, calibration_inputs.yaml and calibration_report.json: mapping, balls,
/// verdict, sentences. Empty stay the results from the presses' images (presses, residuals, zones,
/// fault_signs), the comparison with other methods and details of calibrate() (weakness,
/// radius_sensitivity). A report of an earlier version has its sentences in English and no
/// next_press. Errors: the finger is not calibrated; a file is missing or unreadable; the report
/// belongs to another calibration than finger.yaml.
[[nodiscard]] Result<FingerCalibration> recall_calibration(const std::filesystem::path& folder);

/// The same with residuals, zones and fault_signs: every stored press is run through the pipeline
/// again, some tenths of a second each. `presses` stays empty, so that no image is held in memory.
/// Errors: those of reading the presses; an image in presses/ is missing or has changed since the
/// calibration; the job was stopped.
[[nodiscard]] Result<FingerCalibration> recall_residuals(const std::filesystem::path& folder,
                                                         FingerCalibration recalled,
                                                         const Job& job);

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

}  // namespace alltact
