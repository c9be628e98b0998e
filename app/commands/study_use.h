// What becomes of what a study found: kept with the finger, and measured with from now on.
#pragma once

#include "app/commands/commands.h"
#include "calibration/study/accuracy_study.h"

#include <string>

#include <CLI/CLI.hpp>

namespace alltact {

/// `--save` and `--use`.
void add_use_flags(CLI::App& command, StudyCommandOptions& options);

/// What is asked for makes no sense together. Throws CLI::ValidationError.
void check_use_flags(const StudyCommandOptions& options);

/// What is asked for is kept already, so that no study is needed.
[[nodiscard]] bool uses_what_is_kept(const StudyCommandOptions& options);

/// Lets a finger measure with a preset that it keeps, or as it was calibrated. Errors: those of
/// preset_settings() and use_settings().
[[nodiscard]] Status use_what_is_kept(const Path& finger,
                                      const std::string& name,
                                      Console& console);

/// Keeps and uses what a study of the finger found, as far as the options ask for it. Errors: the
/// preset brings nothing on this finger; nothing is within the limit; those of keep_presets().
[[nodiscard]] Status keep_and_use(const StudyCommandOptions& options,
                                  const AccuracyStudy& study,
                                  const Path& finger,
                                  const std::string& machine,
                                  Console& console);

}  // namespace alltact
