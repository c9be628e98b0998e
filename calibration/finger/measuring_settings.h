// The settings of a finger for all measurements.
#pragma once

#include "core/sensing/pipeline_settings.h"

#include <filesystem>

namespace alltact {

/// Those of its calibration, with the changes of the preset in use (measuring_presets.h). An
/// unreadable preset file changes nothing.
[[nodiscard]] PipelineSettings measuring_settings(const std::filesystem::path& finger_folder);

/// The pipeline's settings in calibration_inputs.yaml: a mapping requires the smoothing, edges and
/// reference that its presses were measured with. contact_threshold_mm, which no mapping depends
/// on, has its default. Without a readable file (not calibrated): the default settings.
[[nodiscard]] PipelineSettings calibrated_settings(const std::filesystem::path& finger_folder);

}  // namespace alltact
