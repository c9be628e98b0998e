// The basis of a calibration: the given numbers and the coverage of the face by its presses.
#pragma once

#include "calibration/finger/calibrate_finger.h"

namespace alltact {

/// Needs a solved calibration with residuals, pixel and halo figures. `camera` and `face` are those
/// of done.finger.
[[nodiscard]] CalibrationBasis basis_of(const FingerCalibration& done);

/// Standard deviation of depth from the mapping's covariance, mm along z: root mean square over its
/// domain. 0 without a covariance.
[[nodiscard]] double scale_sd_mm(const MappingParameters& mapping);

}  // namespace alltact
