// A whole calibration: from press pictures on disk to a finger folder that carries its mapping, and
// the same again from what that folder keeps.
#pragma once

#include "calibration/finger/calibration_inputs.h"
#include "calibration/joint/calibrate.h"
#include "calibration/presses/press_input.h"
#include "calibration/report/fault_signs.h"
#include "calibration/report/halo.h"
#include "calibration/report/method_table.h"
#include "calibration/report/press_residuals.h"
#include "calibration/verdict/verdict.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// A press picture as it was used, or why not.
struct TakenPress {
  std::string name;
  cv::Mat grey;                ///< oriented
  std::optional<Press> press;  ///< absent: nothing could be measured in it
  Message left_out;            ///< why it is not used; empty: it is
  PressSign sign;
};

struct FingerCalibration {
  Finger finger;  ///< as saved
  CalibrationInputs inputs;
  std::vector<TakenPress> presses;  ///< all that were given
  Calibration calibration;
  std::vector<PressResiduals> residuals;
  std::vector<ZoneError> zones;
  std::vector<MethodRow> methods;  ///< for the reports; empty without, or with another method
  double pixel_mm = 0;             ///< see contact_error.h
  double pixel_sd_mm = 0;          ///< standard deviation, without the mapping's share
  Halo halo;                       ///< light that scatters sideways
  int failed_presses = 0;          ///< that no ball was found in, or that did not fit
  bool is_complete = true;         ///< false: stopped before the solution had settled
  std::vector<Contradiction> contradictions;  ///< between numbers given and presses
  Verdict verdict;
  std::vector<Message> fault_signs;       ///< see fault_signs.h
  std::vector<Message> made_of;           ///< what bursts were averaged, a sentence each
  std::filesystem::path problem_picture;  ///< of presses that were left out; empty: none
  std::vector<Message> warnings;          ///< about files and how it was called
  std::vector<Message> about_settings;    ///< of camera and light that do not fit together
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
  PressSet said;                                   ///< of the presses, by their names
  std::optional<std::filesystem::path> reference;  ///< flat sensors: the untouched picture
  CalibrationSettings calibration;
  PipelineSettings pipeline;
  std::string date;             ///< for the record, as utc_now() writes it; empty: now
  std::string program_version;  ///< for the record
  MakeReport make_report;       ///< empty: calibration_report.json alone
  /// Compares with other methods, which make_report does in any case.
  bool compare_methods = false;
  RoundListener on_round;  ///< of the calibration itself, see calibrate(); may be empty
};

/// Runs every press through the pipeline, calibrates, and writes into the finger's folder: the
/// presses (presses/NAME.png), the flat sensor's reference, calibration_inputs.yaml,
/// calibration_report.json, what make_report gives, and last finger.yaml. A press in which no ball
/// is found is left out with its reason; a picture that cannot be used at all fails the whole.
/// Errors: those of loading, of the first picture that is unreadable or has another size, two
/// presses of one name, something said of a press that is not there, no usable
/// press, the job was stopped. On any error before writing the folder is as it was, but for a
/// picture of presses that could not be used (press_problem.h); and whatever ends the program while
/// it writes, all files are those of before or all are new (FolderChange).
[[nodiscard]] Result<FingerCalibration> calibrate_finger(const FingerCalibrationInput& input,
                                                         const Job& job);

/// The same from what the finger keeps. `inputs`: as CalibrationInputs::load gave them, or with
/// other radii, other settings or exclusions. Without a change the files are the same bytes,
/// date included; a change, another version of the program and another reference make a new
/// calibration, dated now. Errors: as above; a picture in presses/ that is gone or is not the one
/// that was calibrated with.
[[nodiscard]] Result<FingerCalibration> calibrate_finger_again(const std::filesystem::path& folder,
                                                               CalibrationInputs inputs,
                                                               const std::string& program_version,
                                                               const MakeReport& make_report,
                                                               const Job& job);

/// What a calibration changes of a finger: the mapping and what is known of how it came about.
void take_calibration(const Finger& from, Finger& finger);

}  // namespace alltact
