// Where a calibration's presses contradict the numbers that were given for it.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "calibration/verdict/contradiction.h"

#include <vector>

namespace alltact {

/// Of a calibration that has been solved: presses, balls, finger and inputs are those of `done`;
/// its verdict is not read. Presses that were left out count as well. Worst first.
[[nodiscard]] std::vector<Contradiction> find_contradictions(const FingerCalibration& done);

}  // namespace alltact
