// What a command measures a finger with.
#pragma once

#include "app/console/console.h"
#include "core/result.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <string>

namespace alltact {

/// What the finger uses; where `preset` is not empty, those of that name. Errors: those of
/// presets_of_finger() and preset_settings().
[[nodiscard]] Result<PipelineSettings> kept_settings(const std::filesystem::path& finger,
                                                     const std::string& preset);

/// A mapping holds for the settings that its presses were read with.
void warn_of_other_settings(const PipelineSettings& kept,
                            const PipelineSettings& asked,
                            Console& console);

}  // namespace alltact
