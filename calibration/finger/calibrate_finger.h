// A full calibration: from press images on disk to a finger folder with its mapping, and its
// repetition from that folder's stored inputs.
#pragma once

#include "calibration/finger/calibration_inputs.h"
#include "calibration/joint/calibrate.h"
#include "calibration/presses/press_input.h"
#include "calibration/report/calibration_faults.h"
#include "calibration/report/press_errors.h"
#include "calibration/verdict/verdict.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sensing/reference/reference_image.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// A press image as it was measured, or the reason why it is not used. Copies share the images,
/// which nobody may write to.
struct MeasuredPress {
  std::string name;
  cv::Mat grey;                ///< oriented
  std::optional<Press> press;  ///< empty: nothing could be measured in it
  Message left_out;            ///< why it is not used; empty: it is
  PressSign sign;
  std::optional<Reference> reference = std::nullopt;  ///< until it is solved: compared with this
  std::optional<FaceShape> shape = std::nullopt;      ///< of a face where `press` is empty
  std::string key = {};                               ///< of all it depends on; empty: unknown
};

struct FingerCalibration {
  Finger finger;  ///< as saved
  CalibrationInputs inputs;
  std::vector<MeasuredPress> presses;  ///< all that were given, without their references
  Calibration calibration;
  /// As it was solved, before remarks of this list: whoever solves the same shares it. Null where
  /// it was stopped, or read from a file.
  std::shared_ptr<const Calibration> solution;
  std::vector<PressResiduals> residuals;
  std::vector<ZoneError> zones;
  std::vector<MethodRow> methods;             ///< compared, for the reports; may be empty
  double pixel_mm = 0;                        ///< see press_errors.h
  double pixel_sd_mm = 0;                     ///< standard deviation, without the mapping's share
  Halo halo;                                  ///< light that scatters sideways
  int failed_presses = 0;                     ///< without a detected ball, or without a fit
  bool is_complete = true;                    ///< false: stopped before the solution had settled
  std::vector<Contradiction> contradictions;  ///< between numbers given and presses
  Verdict verdict;
  std::vector<Message> fault_signs;     ///< see calibration_faults.h
  std::vector<Message> source_remarks;  ///< of the presses: Source::remarks()
  std::filesystem::path problem_image;  ///< of presses that were left out; empty: none
  std::vector<Message> warnings;        ///< about files and options
  std::vector<Message> about_settings;  ///< of camera and light that do not fit together
};

/// A file to be written into the finger's folder.
struct ReportFile {
  std::string name;
  std::string content;
};
/// Makes reports of a calibration that is about to be written.
using MakeReport =
    std::function<Result<std::vector<ReportFile>>(const FingerCalibration&, const Job&)>;

struct FingerCalibrationInput {
  std::filesystem::path folder;  ///< the finger's
  PressInput presses;
  PressSet press_set;                              ///< of the presses, by their names
  std::optional<std::filesystem::path> reference;  ///< flat sensors: the untouched image
  CalibrationSettings calibration;
  PipelineSettings pipeline;
  std::string date;             ///< for the record, as utc_now() writes it; empty: now
  std::string program_version;  ///< for the record
  MakeReport make_report;       ///< empty: calibration_report.json alone
  /// Compares with other methods, for the reports: takes longer than the calibration itself.
  bool compare_methods = false;
  bool discard_if_stopped = false;  ///< instead of storing the best solution so far
  RoundListener on_round;           ///< of the calibration itself, see calibrate(); may be empty
};

/// Runs every press through the pipeline, calibrates, and writes into the finger's folder: the
/// presses (presses/NAME.png), the flat sensor's reference, calibration_inputs.yaml,
/// calibration.yaml, calibration_report.json, the files of make_report, and last finger.yaml. A
/// press without a detected ball is left out with its reason; an unusable image fails the entire
/// calibration.
///
/// Errors: those of loading and of the first image that is unreadable or has another size; two
/// presses of one name; notes on a press that does not exist; no usable press; stopped. On an error
/// before writing the folder stays unchanged, except for an image of unusable presses.
/// If the program ends while it writes, either all files are old or all are new
/// (FolderChange).
[[nodiscard]] Result<FingerCalibration> calibrate_finger(const FingerCalibrationInput& input,
                                                         const Job& job);

/// The same from the finger's stored inputs. `inputs`: as CalibrationInputs::load returns them, or
/// with other radii, settings or exclusions. Without a change the files are the same bytes, date
/// included. A change, another version of the program or another reference makes a new calibration,
/// dated now. Errors: as above; an image in presses/ is missing or has changed since the
/// calibration.
[[nodiscard]] Result<FingerCalibration> calibrate_finger_again(const std::filesystem::path& folder,
                                                               CalibrationInputs inputs,
                                                               const std::string& program_version,
                                                               const MakeReport& make_report,
                                                               bool compare_methods,
                                                               const Job& job);

/// Copies the fields that a calibration defines: the mapping and its records.
void take_calibration(const Finger& from, Finger& finger);

}  // namespace alltact
