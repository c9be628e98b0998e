// The settings that a finger is measured with, wherever it is measured.
#pragma once

#include "core/sensing/pipeline_settings.h"

#include <filesystem>

namespace alltact {

/// What the finger measures with: those of its calibration, with what a preset that it uses
/// (measuring_presets.h) changes. A preset file that cannot be read changes nothing.
[[nodiscard]] PipelineSettings measuring_settings(const std::filesystem::path& finger_folder);

/// What calibration_inputs.yaml keeps of the pipeline: a mapping holds for the smoothing, edges and
/// reference that its presses were read with. contact_threshold_mm, which no mapping depends on,
/// stays as usual. A folder that keeps none (not calibrated, or its inputs cannot be read): the
/// usual settings.
[[nodiscard]] PipelineSettings calibrated_settings(const std::filesystem::path& finger_folder);

}  // namespace alltact
