// The first part of a calibration: every press is read and measured.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "calibration/reference/reference_recording.h"
#include "core/frame.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace alltact {

/// One running calibration, first or repeated.
struct CalibrationWork {
  std::shared_ptr<FingerStore> store;
  PressInput presses;
  std::optional<UntouchedImage> untouched;  ///< of a flat sensor: to be installed
  bool is_repetition = false;               ///< the presses must be those of `stored`
  CalibrationInputs stored;                 ///< the stored inputs of the repeated calibration
  MakeReport make_report;
  bool compare_methods = false;
  RoundListener on_round;
  std::vector<FramePtr> frames;                      ///< one a press, in their stored form
  std::vector<std::optional<Reference>> references;  ///< of each press
};

/// A pipeline's measurement of a press, before its notes are applied; difference and face are moved
/// out of `result`.
[[nodiscard]] TakenPress press_of(const std::string& name, FrameResult& result);
/// Applies the notes: ball, depth, step, exclusion.
void apply_notes(const PressSet& press_set, TakenPress& press);

/// Reads the images and runs them through the pipeline. `done` receives its presses, its bursts,
/// and whether the source is continuous; `work` receives frames and references. `done.finger` and
/// `done.inputs` are those of the calibration. Errors: those of loading; the first image that is
/// unreadable, has another size or differs from the stored one; two presses of one name; notes on a
/// press that does not exist; stopped.
[[nodiscard]] Status take_presses(CalibrationWork& work, FingerCalibration& done, const Job& job);

/// The same presses measured again by the source paper's own steps, for comparison. Errors: those
/// of PaperMethod::create and paper_presses().
[[nodiscard]] Result<std::vector<Press>> take_presses_as_paper(const CalibrationWork& work,
                                                               const FingerCalibration& done,
                                                               const Job& job);

}  // namespace alltact
