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

/// One calibration on its way, first or again.
struct CalibrationWork {
  std::shared_ptr<FingerStore> store;
  PressInput presses;
  std::optional<UntouchedPicture> untouched;  ///< of a flat sensor: to be installed
  bool is_repetition = false;                 ///< of `kept`, whose presses these are to be
  CalibrationInputs kept;                     ///< what is repeated, as it was stored
  MakeReport make_report;
  bool compare_methods = false;
  RoundListener on_round;
  std::vector<FramePtr> frames;                      ///< one a press, as they are to be kept
  std::vector<std::optional<Reference>> references;  ///< what each was compared with
};

/// What a pipeline measures of a press, before anything is said of it; difference and face are
/// moved out of `result`.
[[nodiscard]] TakenPress press_of(const std::string& name, FrameResult& result);
/// Its ball, its depth, its step; one that is excluded is left out.
void take_what_is_said(const PressSet& said, TakenPress& press);

/// Reads the pictures and runs them through the pipeline: `done` gets its presses and what bursts
/// were made of, and is told whether the source is continuous; `work` gets frames and references.
/// `done.finger` and `done.inputs` are those of the calibration. Errors: those of loading, of the
/// first picture that is unreadable or has another size or is not the one that was kept, two
/// presses of one name, something said of a press that is not there, the job was stopped.
[[nodiscard]] Status take_presses(CalibrationWork& work, FingerCalibration& done, const Job& job);

/// The presses that were taken, measured again by the source paper's own steps, to compare with.
/// Errors: those of PaperMethod::create and paper_presses().
[[nodiscard]] Result<std::vector<Press>> take_presses_as_paper(const CalibrationWork& work,
                                                               const FingerCalibration& done,
                                                               const Job& job);

}  // namespace alltact
