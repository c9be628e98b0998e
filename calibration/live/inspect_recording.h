// Inspects a recording of a finger by a recipe, with the finger's own settings: for the command
// line and the window alike.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/inspection/inspection_log.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct InspectionOrder {
  std::filesystem::path finger;               ///< its folder
  std::vector<std::filesystem::path> inputs;  ///< as open_source() reads them
  InspectionRecipe recipe;
  int threads = 0;  ///< 0: all cores; the log does not depend on it
};

/// Errors: those of opening finger and source, and of inspect().
[[nodiscard]] Result<InspectionLog> inspect_recording(const InspectionOrder& order, const Job& job);

// Several recordings by one recipe.

struct InspectedRecording {
  std::filesystem::path recording;
  std::optional<InspectionLog> log;  ///< empty: it could not be inspected
  Message problem;                   ///< why
};

/// Inspects each input as a recording of its own; a folder with videos stands for these, in the
/// order of their names. One that fails does not end the others. Errors: no input; stopped.
[[nodiscard]] Result<std::vector<InspectedRecording>> inspect_recordings(
    const InspectionOrder& order, const Job& job);

/// A line for each recording and reading, or for a recording that could not be inspected:
///   recording,reading,what,unit,frames,measured,mean,sd,min,max,trend,trend_sd,trend_per,passed,
///   failed,undecided,problem
[[nodiscard]] std::string csv_of(const std::vector<InspectedRecording>& recordings);

}  // namespace alltact
