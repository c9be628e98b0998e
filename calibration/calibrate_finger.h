// A whole calibration: from press pictures on disk to a finger folder that carries its mapping.
#pragma once

#include "calibration/calibrate.h"
#include "calibration/verdict.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct FingerCalibrationInput {
  std::filesystem::path folder;                ///< the finger's
  std::vector<std::filesystem::path> presses;  ///< pictures, folders or a video; see open_source
  double ball_radius_mm = 0;
  std::optional<std::filesystem::path> reference;  ///< flat sensors: the untouched picture
  CalibrationSettings calibration;
  PipelineSettings pipeline;
  std::string program_version;  ///< for the record
  std::string operator_name;    ///< for the record; empty: not told
};

struct FingerCalibration {
  Finger finger;  ///< as saved
  Calibration calibration;
  Verdict verdict;
  std::vector<std::string> warnings;  ///< about the finger's file and its settings
};

/// Runs every press through the pipeline, calibrates, and writes into the finger's folder: the
/// presses (presses/NAME.png), the flat sensor's reference, calibration_report.json and last
/// finger.yaml. A press in which no ball is found is left out with its reason; a picture that
/// cannot be used at all fails the whole. Errors: those of loading, of the first picture that is
/// unreadable or has another size, two presses of one name, no usable press. On any error before
/// writing the folder is as it was.
[[nodiscard]] Result<FingerCalibration> calibrate_finger(const FingerCalibrationInput& input,
                                                         const Job& job);

/// Date and time in UTC as 2026-01-31T12:00:00Z.
[[nodiscard]] std::string utc_now();

}  // namespace alltact
