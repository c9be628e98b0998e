// Names of camera controls in the window's language.
#pragma once

#include "core/sources/v4l2/camera_controls.h"

#include <QString>

namespace alltact {

/// The driver's own name for a control that is not one of V4L2's standard ones.
[[nodiscard]] QString control_name(const CameraControl& control);

}  // namespace alltact
