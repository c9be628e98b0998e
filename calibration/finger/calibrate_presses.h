// The first part of a calibration: every press is read and measured.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "calibration/reference/reference_recording.h"
#include "calibration/verdict/verdict.h"
#include "core/image/frame.h"
#include "core/sensing/pipeline.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
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
  bool compare_methods = false, discard_if_stopped = false;
  RoundListener on_round;
  std::vector<FramePtr> frames;  ///< one a press, in their stored form
};

/// Measures presses, before their notes are applied. One thread at a time.
class PressMeter {
 public:
  using Measured = Result<std::shared_ptr<const MeasuredPress>>;

  /// `pipeline`: of a finger without a mapping. `reference_checksum`: of its reference; empty:
  /// unknown, and no press is shared.
  PressMeter(Pipeline pipeline, const std::string& reference_checksum);

  /// A press that is independent of others. The same name, image, camera, face, markers, reference
  /// and settings are measured once: as long as anybody in this program holds that press, it is
  /// returned again. Errors: those of Pipeline; stopped while another thread measures it.
  [[nodiscard]] Measured operator()(const FramePtr& frame, const Job& job);
  /// The next press of one video, whose markers are followed from press to press: never shared.
  [[nodiscard]] Measured next(const FramePtr& frame);

  [[nodiscard]] const Pipeline& pipeline() const { return pipeline_; }

 private:
  Measured measure(const FramePtr& frame, std::string key);

  Pipeline pipeline_;
  std::string key_;  ///< of all but the frame; empty: not shared
};

/// Measurements by all meters of this program: tests count them.
[[nodiscard]] std::int64_t press_measurements();

/// Reads the images and measures them. `done` receives its presses, its bursts, the reference's
/// checksum, and whether the source is continuous; `work` receives the frames. `done.finger` and
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

using MeasureAsPaper = std::function<Result<std::vector<Press>>(const Job&)>;

/// Calibrates with the presses of `done` that are not left out, and fills its residuals, zones,
/// signs of a fault, verdict and remarks. The same presses, notes and settings are solved once: as
/// long as anybody in this program holds that solution, it is used again. The presses' references
/// are released. `as_paper`: the same presses measured by the source paper's method, for a
/// comparison of methods; empty: none is made. `on_round`: see calibrate(). Errors: no usable
/// press; those of calibrate(); a method that does not support the notes on the presses, or is not
/// compared with others.
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
/// pipeline's settings are the same. `presses`: as PressMeter returns them. `inputs` holds the
/// settings and the notes on the presses. Errors: those of solve_presses() and load_bodies().
[[nodiscard]] Result<FingerCalibration> forecast_calibration(
    const Finger& finger, const std::filesystem::path& finger_folder,
    std::vector<MeasuredPress> presses, const CalibrationInputs& inputs, const Job& job);

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
