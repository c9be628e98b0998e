// Inspects a recording of a finger by a recipe, with the finger's own settings: for the command
// line and the window alike.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/inspection/inspection_log.h"

#include <filesystem>
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

}  // namespace alltact
