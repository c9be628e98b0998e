// The first part of a calibration: every press is read and measured.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "calibration/reference/reference_recording.h"
#include "calibration/verdict/verdict.h"
#include "core/image/frame.h"
#include "core/sensing/frame_result.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// One running calibration, first or repeated.
struct CalibrationWork {
  std::shared_ptr<FingerStore> store;
  PressInput presses;
  std::optional<UntouchedImage> untouched;  ///< of a flat sensor: to be installed
  std::optional<CalibrationInputs> stored;  ///< repetition: the presses must be these; else empty
  MakeReport make_report;
  bool compare_methods = false;
  RoundListener on_round;
  std::vector<FramePtr> frames;  ///< one a press, in their stored form
};

/// A pipeline's measurement of a press, before its notes are applied; difference, face and
/// reference are moved out of `result`.
[[nodiscard]] TakenPress press_of(const std::string& name, FrameResult& result);

/// Reads the images and runs them through the pipeline. `done` receives its presses, its bursts,
/// and whether the source is continuous; `work` receives the frames. `done.finger` and
/// `done.inputs` are those of the calibration. Errors: those of loading; the first image that is
/// unreadable, has another size or differs from the stored one; two presses of one name; notes on a
/// press that does not exist; stopped.
[[nodiscard]] Status take_presses(CalibrationWork& work, FingerCalibration& done, const Job& job);

/// The same presses measured again by the source paper's own steps, for comparison. Errors: those
/// of PaperMethod::create and paper_presses().
[[nodiscard]] Result<std::vector<Press>> take_presses_as_paper(const CalibrationWork& work,
                                                               const FingerCalibration& done,
                                                               const Job& job);

// The second part of a calibration: from measured presses to a mapping and its quality.

using MeasureAsPaper = std::function<Result<std::vector<Press>>()>;

/// Calibrates with the presses of `done` that are not left out, and fills its residuals, zones,
/// signs of a fault, verdict and remarks. The presses' references are released. `as_paper`: the
/// same presses measured by the source paper's method; called only for a comparison of methods.
/// `on_round`: see calibrate(). Errors: no usable press; those of calibrate(); a method that does
/// not support the notes on the presses.
[[nodiscard]] Status solve_presses(FingerCalibration& done, const MeasureAsPaper& as_paper,
                                   const Job& job, const RoundListener& on_round);

/// The record of a calibration in finger.yaml, next to its mapping.
[[nodiscard]] MappingRecord record_of(const FingerCalibration& done);

// Contradictions between a calibration's presses and the numbers given for it.

/// Needs a solved calibration with presses, balls, finger and inputs; its verdict is not read.
/// Presses that were left out count as well. Worst first.
[[nodiscard]] std::vector<Contradiction> find_contradictions(const FingerCalibration& done);

// Predicted result of a calibration with the current presses and notes, and the fit of one press in
// it. Nothing is written.

/// The figures of calibrate_finger() with these presses, in the order of their names, if the
/// pipeline's settings are the same. `presses`: as press_of() returns them. `inputs` holds the
/// settings and the notes on the presses. Errors: those of solve_presses().
[[nodiscard]] Result<FingerCalibration> forecast_calibration(const Finger& finger,
                                                             std::vector<TakenPress> presses,
                                                             const CalibrationInputs& inputs,
                                                             const Job& job);

/// One press compared with a known mapping, its ball at `centre_mm`: about 12 ms.
struct PressFit {
  PressResiduals residuals;
  /// Mean magnitude of the residuals in the inner part of the contact (kInnerRim), mm.
  double error_mm = 0;
  int side_px = 1;  ///< of the squares that the samples are means over
};
/// nullopt where nothing of the press lies under the ball.
[[nodiscard]] std::optional<PressFit> fit_of_press(const Press& press, const Face& face,
                                                   const MappingParameters& mapping,
                                                   const Eigen::Vector3d& centre_mm);

}  // namespace alltact
