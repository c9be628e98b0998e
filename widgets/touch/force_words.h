// Why no force is told.
#pragma once

#include "calibration/live/live_finger.h"

#include <QString>

namespace alltact {

/// Rich text, with what to do.
[[nodiscard]] QString why_no_force(const FingerStatus& finger);

}  // namespace alltact
