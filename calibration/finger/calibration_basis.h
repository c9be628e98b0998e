// What a calibration rests on: the numbers given for it and what its presses cover on the face.
#pragma once

#include "calibration/finger/calibrate_finger.h"

namespace alltact {

/// Of a solved calibration whose residuals, pixel and halo figures are there already. `camera` and
/// `face` are those of done.finger.
[[nodiscard]] CalibrationBasis basis_of(const FingerCalibration& done);

/// Standard deviation of depth by the mapping's covariance, mm along z: root mean square over its
/// domain. 0 where there is none.
[[nodiscard]] double scale_sd_mm(const MappingParameters& mapping);

}  // namespace alltact
