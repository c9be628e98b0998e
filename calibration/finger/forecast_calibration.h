// Predicted result of a calibration with the current presses and notes, and the fit of one press in
// it. Nothing is written.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "core/sensing/reference/reference_library.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A press as it was measured; its notes are applied when it is used.
struct ReferencedPress {
  TakenPress taken;
  std::optional<Reference> reference;  ///< that it was compared with
};

/// The figures of calibrate_finger() with these presses, in the order of their names, if the
/// pipeline's settings are the same. `inputs` holds the settings and the notes on the presses.
/// Errors: those of solve_presses().
[[nodiscard]] Result<FingerCalibration> forecast_calibration(
    const Finger& finger,
    const std::vector<ReferencedPress>& presses,
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
[[nodiscard]] std::optional<PressFit> fit_of_press(const Press& press,
                                                   const Face& face,
                                                   const MappingParameters& mapping,
                                                   const Eigen::Vector3d& centre_mm);

}  // namespace alltact
