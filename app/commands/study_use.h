// Stores the result of a study with the finger, and sets the settings in use.
#pragma once

#include "app/commands/commands.h"
#include "calibration/study/accuracy_study.h"

#include <string>

#include <CLI/CLI.hpp>

namespace alltact {

/// `--save` and `--use`.
void add_use_flags(CLI::App& command, StudyCommandOptions& options);

/// Refuses options that do not go together. Throws CLI::ValidationError.
void check_use_flags(const StudyCommandOptions& options);

/// The requested preset is stored already, so that no study is needed.
[[nodiscard]] bool uses_stored_preset(const StudyCommandOptions& options);

/// Makes a finger measure with one of its stored presets, or as it was calibrated. Errors: those of
/// preset_settings() and use_settings().
[[nodiscard]] Status use_stored_preset(const Path& finger,
                                       const std::string& name,
                                       Console& console);

/// Stores and uses the result of a study of the finger, as far as the options request it. Errors:
/// the preset has no advantage on this finger; nothing is within the limit; those of
/// save_presets().
[[nodiscard]] Status save_and_use(const StudyCommandOptions& options,
                                  const AccuracyStudy& study,
                                  const Path& finger,
                                  const std::string& machine,
                                  Console& console);

}  // namespace alltact
