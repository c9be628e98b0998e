// Output files of every study.
#pragma once

#include "app/commands/commands.h"
#include "core/result.h"

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace alltact {

/// Program, date, machine with its power, seed.
[[nodiscard]] Console::Json study_provenance(const StudyCommandOptions& options);

struct StudyFiles {
  nlohmann::json json;   ///< of the study itself
  std::string csv, svg;  ///< svg: empty where there is no figure
};

/// Writes study.json (with `provenance`), study.csv and study.svg into the folder, and prints it.
/// Also study.png and study.pdf where this computer has the library that draws. Error: a file
/// cannot be written.
[[nodiscard]] Status write_study(const StudyFiles& files,
                                 const Console::Json& provenance,
                                 const Path& folder,
                                 Console& console);

/// `alltact study --calibrating`, `--simulating` and `--scaling`.
[[nodiscard]] Status run_calibrating_study(const StudyCommandOptions& options, Console& console);
[[nodiscard]] Status run_simulating_study(const StudyCommandOptions& options, Console& console);
[[nodiscard]] Status run_scaling_study(const StudyCommandOptions& options, Console& console);

}  // namespace alltact
