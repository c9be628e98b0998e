// Reloads the result of a calibration from a finger's files, without solving.
#pragma once

#include "calibration/finger/calibrate_finger.h"

#include <filesystem>

namespace alltact {

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

}  // namespace alltact
