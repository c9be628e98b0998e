// Camera and face for other programs, alike in files and streams.
#pragma once

#include "core/finger/finger.h"

#include <nlohmann/json.hpp>

namespace alltact {

[[nodiscard]] nlohmann::ordered_json camera_json(const CameraParameters& camera);
[[nodiscard]] nlohmann::ordered_json face_json(const Face& face);

}  // namespace alltact
