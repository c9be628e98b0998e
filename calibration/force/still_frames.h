// Frames in which the finger rests as it did when somebody read the gauge.
#pragma once

#include "calibration/force/collect_force.h"

#include <vector>

namespace alltact {

/// For each reading that holds, which frames it is of: those around its time, without a break,
/// whose markers lie within 4 times their noise (0.3 to 1.5 px) root mean square of where they lay
/// then, at most to the readings before and behind it. -1: of none. Frames with times, ascending.
[[nodiscard]] std::vector<int> held_readings(const std::vector<MarkerFrame>& frames,
                                             const ForceGauge& gauge,
                                             const GaugeClock& clock);

}  // namespace alltact
