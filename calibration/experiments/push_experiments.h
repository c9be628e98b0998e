// Pushes of known force on a bench's finger: what force models are taught with and tried on.
#pragma once

#include "calibration/experiments/experiment_bench.h"
#include "calibration/force/force_table.h"
#include "calibration/force/train_force.h"

namespace alltact {

/// The scene that forces are learnt from, and after how many frames a place comes again.
inline constexpr const char* kForceScene = "experiment_force";
inline constexpr int kForcePlaces = 22;

struct ExperimentBench::Drawn {
  ExperimentBench bench;
  ForceTable table;
  TrainedForce trained;
};

/// Measures a scene's pushes frame by frame. Rows are of one block where the scene repeats their
/// place along the finger, `places` of them in turn. Errors: those of the bench; frames too few
/// whose markers are found.
[[nodiscard]] Result<ForceTable> table_of_pushes(const ExperimentBench& bench,
                                                 const std::string& scene,
                                                 int places);

/// What the experiments train with.
[[nodiscard]] ForceTraining training_of_experiments();

}  // namespace alltact
