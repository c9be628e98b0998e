// Content of exported files and of messages to other programs. Numbers have all their digits and do
// not depend on the locale.
#pragma once

#include "calibration/verdict/verdict.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/sensing/pipeline_settings.h"

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

namespace alltact {

/// Error: the camera has no camera matrix; `where` is empty.
[[nodiscard]] Result<std::string> opencv_camera(const Finger& finger);
[[nodiscard]] Result<std::string> ros_camera_info(const Finger& finger);
/// Error: the mapping is invalid.
[[nodiscard]] Result<std::string> ros_parameters(const Finger& finger);
/// `worth`: current verdict on the calibration; empty: not written.
[[nodiscard]] Result<std::string> calibration_json(
    const Finger& finger, const PipelineSettings& settings = {},
    const std::optional<Verdict>& worth = std::nullopt);

// Camera and face for other programs, alike in files and streams.

[[nodiscard]] nlohmann::ordered_json camera_json(const CameraParameters& camera);
[[nodiscard]] nlohmann::ordered_json face_json(const Face& face);

}  // namespace alltact
