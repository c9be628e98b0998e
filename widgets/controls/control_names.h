// What a camera's controls are called in the window's language.
#pragma once

#include "core/sources/v4l2/camera_controls.h"

#include <QString>

namespace alltact {

/// The driver's own name where it is none of the usual ones.
[[nodiscard]] QString control_name(const CameraControl& control);

}  // namespace alltact
