// Explains why there is no force.
#pragma once

#include "calibration/live/live_finger.h"

#include <QString>

namespace alltact {

/// Rich text, with what to do.
[[nodiscard]] QString no_force_reason(const FingerStatus& finger);

}  // namespace alltact
