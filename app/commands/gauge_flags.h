// Flags of commands for a force gauge, and messages about it.
#pragma once

#include "app/console/console.h"
#include "calibration/force/collect_force.h"
#include "core/devices/gauge_log.h"
#include "core/devices/open_gauge.h"

#include <CLI/CLI.hpp>

namespace alltact {

/// For a gauge that is read while recording.
void add_gauge_flags(CLI::App& command, GaugeChoice& gauge);

/// For a gauge's file; `collect` is the flag that they go with.
void add_gauge_file_flags(CLI::App& command, CLI::Option* collect, GaugeFileOptions& file,
                          CollectOptions& options);

/// Null where no gauge is chosen. Errors: those of gauge_opener and of opening it.
[[nodiscard]] Result<std::unique_ptr<GaugeLog>> start_gauge(const GaugeChoice& gauge);

/// Prints the readings since the last call, for the person at the gauge.
void print_gauge(GaugeLog* gauge, Console& console);

/// Completes the file next to `video` and prints its content.
[[nodiscard]] Status end_gauge(GaugeLog* gauge, const std::filesystem::path& video,
                               Console::Json& answer, Console& console);

}  // namespace alltact
