// What a calibration came to, told again later from what the finger keeps, without solving.
#pragma once

#include "calibration/finger/calibrate_finger.h"

#include <filesystem>

namespace alltact {

/// At once, from finger.yaml, calibration_inputs.yaml and calibration_report.json: mapping, balls,
/// verdict, what was said. Empty are what only the pictures of the presses can tell (presses,
/// residuals, zones, fault_signs), the comparison with other methods and what calibrate() knows
/// beside its sentences (weakness, radius_sense). A report that an earlier version wrote gives its
/// sentences in English and no next_press.
/// Errors: the finger is not calibrated; a file is missing or unreadable; the report tells of
/// another calibration than finger.yaml.
[[nodiscard]] Result<FingerCalibration> recall_calibration(const std::filesystem::path& folder);

/// The same with residuals, zones and fault_signs: every press that is kept is run through the
/// pipeline again, some tenths of a second each. `presses` stays empty, so that no picture is held.
/// Errors: those of reading the presses; a picture in presses/ that is gone or is not the one that
/// was calibrated with; the job was stopped.
[[nodiscard]] Result<FingerCalibration> recall_residuals(const std::filesystem::path& folder,
                                                         FingerCalibration recalled,
                                                         const Job& job);

}  // namespace alltact
