// Pushes of known force on a bench's finger, to train and test force models.
#pragma once

#include "calibration/experiments/experiment_bench.h"
#include "calibration/force/force_table.h"
#include "calibration/force/train_force.h"

namespace alltact {

/// The scene for force training, and the number of frames after which a position repeats.
inline constexpr const char* kForceScene = "experiment_force";
inline constexpr int kForcePositions = 22;

struct ExperimentBench::TrainedVariant {
  ExperimentBench bench;
  ForceTable table;
  TrainedForce trained;
};

/// Measures a scene's pushes frame by frame. Rows at the same position along the finger, which
/// repeats after `positions` frames, form one block. Errors: those of the bench; too few frames
/// with markers.
[[nodiscard]] Result<ForceTable> table_of_pushes(const ExperimentBench& bench,
                                                 const std::string& scene, int positions);

/// Training settings of the experiments.
[[nodiscard]] ForceTraining training_of_experiments();

}  // namespace alltact
