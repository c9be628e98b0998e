// A finger on disk gets another force model.
#pragma once

#include "calibration/force/train_force.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <string>

namespace alltact {

/// Trains a model and keeps it in the finger, as force/model-HASH.json with its table beside, both
/// named after what is in them: an earlier model stays, and take_back_force() returns to it.
/// Errors, after which the finger is as it was: a finger without markers or without reference; a
/// table of other markers; those of train_force and FingerStore::update; somebody else is at work
/// on it.
[[nodiscard]] Result<TrainedForce> give_force(const std::filesystem::path& folder,
                                              const ForceTable& table,
                                              const ForceTraining& options,
                                              const Job& job);

/// The model from before the last give_force(), or none where there was none; done twice, nothing
/// has changed. Error: nothing was given yet; the file is gone.
[[nodiscard]] Result<FingerPtr> take_back_force(const std::filesystem::path& folder);

/// The table of the finger's force model. Error: it has none, or the table is gone.
[[nodiscard]] Result<ForceTable> kept_force_table(const std::filesystem::path& folder);

/// How the finger's force model was trained: split, kind if one was asked for, creep. What is not
/// told there is as usual. Errors: those of kept_force_table, but for the table itself.
[[nodiscard]] Result<ForceTraining> kept_force_training(const std::filesystem::path& folder);

/// Error: the rows are not of this finger's markers.
[[nodiscard]] Status check_force_markers(const ForceTable& table, const Finger& finger);

}  // namespace alltact
