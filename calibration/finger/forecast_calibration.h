// What calibrating would come to with presses as they are said to be now, and what one press would
// be in it: nothing is written.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "core/sensing/reference/reference_library.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A press as it was measured once; what is said of it is taken when it is used.
struct ReferencedPress {
  TakenPress taken;
  std::optional<Reference> reference;  ///< what it was compared with
};

/// The figures of calibrate_finger() with these presses, in the order of their names: those that it
/// would give where the pipeline's settings are the same. `inputs` says which settings and what is
/// said of the presses. Errors: those of solve_presses().
[[nodiscard]] Result<FingerCalibration> forecast_calibration(
    const Finger& finger,
    const std::vector<ReferencedPress>& presses,
    const CalibrationInputs& inputs,
    const Job& job);

/// One press held against a mapping that is known, its ball at `centre_mm`: a dozen milliseconds.
struct PressFit {
  PressResiduals residuals;
  /// Mean magnitude of the residuals in the inner part of the contact (kSureRim), mm.
  double error_mm = 0;
  int side_px = 1;  ///< of the squares that the samples are means over
};
/// nullopt where nothing of the press lies under the ball.
[[nodiscard]] std::optional<PressFit> fit_of_press(const Press& press,
                                                   const Face& face,
                                                   const MappingParameters& mapping,
                                                   const Eigen::Vector3d& centre_mm);

}  // namespace alltact
