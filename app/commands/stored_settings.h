// The settings that a command measures a finger with.
#pragma once

#include "app/console/console.h"
#include "core/result.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <string>

namespace alltact {

/// The finger's settings in use; where `preset` is not empty, those of that name. Errors: those of
/// presets_of_finger() and preset_settings().
[[nodiscard]] Result<PipelineSettings> stored_settings(const std::filesystem::path& finger,
                                                       const std::string& preset);

/// A mapping is valid for the settings that its presses were measured with.
void warn_of_other_settings(const PipelineSettings& stored,
                            const PipelineSettings& requested,
                            Console& console);

}  // namespace alltact
