// The settings that a finger's mapping was made with, for whatever measures with that mapping.
#pragma once

#include "core/sensing/pipeline_settings.h"

#include <filesystem>

namespace alltact {

/// What calibration_inputs.yaml keeps of the pipeline: a mapping holds for the smoothing, edges and
/// reference that its presses were read with. contact_threshold_mm, which no mapping depends on,
/// stays as usual. A folder that keeps none (not calibrated, or its inputs cannot be read): the
/// usual settings.
[[nodiscard]] PipelineSettings measuring_settings(const std::filesystem::path& finger_folder);

}  // namespace alltact
