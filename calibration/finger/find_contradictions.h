// Contradictions between a calibration's presses and the numbers given for it.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "calibration/verdict/contradiction.h"

#include <vector>

namespace alltact {

/// Needs a solved calibration with presses, balls, finger and inputs; its verdict is not read.
/// Presses that were left out count as well. Worst first.
[[nodiscard]] std::vector<Contradiction> find_contradictions(const FingerCalibration& done);

}  // namespace alltact
