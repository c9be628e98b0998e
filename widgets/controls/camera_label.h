// Names of cameras in lists.
#pragma once

#include "core/sources/v4l2/camera_list.h"

#include <QString>
#include <vector>

namespace alltact {

/// The maker's name; where another camera has the same, with its USB port.
[[nodiscard]] QString camera_label(const FoundCamera& camera,
                                   const std::vector<FoundCamera>& cameras);

}  // namespace alltact
