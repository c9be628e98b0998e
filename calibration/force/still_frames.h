// Frames in which the finger rests as it did when a person read the gauge.
#pragma once

#include "calibration/force/collect_force.h"

#include <vector>

namespace alltact {

/// For each reading that holds, the frames that it applies to, as an index of the reading for each
/// frame. These are the frames around its time, without a gap, whose markers have not moved. The
/// limit is 4 times their noise (0.3 to 1.5 px), root mean square, and the neighbouring readings
/// bound them. -1: none. Frames with times, ascending.
[[nodiscard]] std::vector<int> held_readings(const std::vector<MarkerFrame>& frames,
                                             const ForceGauge& gauge,
                                             const GaugeClock& clock);

}  // namespace alltact
