// Simulated images to compare settings on.
#pragma once

#include "calibration/study/study_world.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>

namespace alltact {

/// The scene study_presses (the demonstration's finger, pressed by a ball at random positions and
/// poses), measured by a finger that is recorded and calibrated from scenes as well.
///   folder: for that finger; those of earlier studies are removed
/// Errors: those of ExperimentBench; stopped.
[[nodiscard]] Result<StudyWorld> simulated_world(const std::filesystem::path& folder,
                                                 const StudyWorldOptions& options,
                                                 const Job& job);

}  // namespace alltact
