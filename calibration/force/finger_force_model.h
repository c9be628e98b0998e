// Trains the force model of a finger on disk, and restores the previous one.
#pragma once

#include "calibration/force/train_force.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <string>

namespace alltact {

/// Trains a model and saves it in the finger, as force/model-HASH.json with its table. Both are
/// named after their content, so an earlier model stays, and revert_force() returns to it.
/// Errors, after which the finger is unchanged: a finger without markers or without reference; a
/// table of other markers; those of train_force and FingerStore::update; another process works on
/// the finger.
[[nodiscard]] Result<TrainedForce> train_finger_force(const std::filesystem::path& folder,
                                                      const ForceTable& table,
                                                      const ForceTraining& options,
                                                      const Job& job);

/// Restores the model from before the last train_finger_force(), or none where there was none; a
/// second call reverts the first. Errors: no model was trained yet; the file is gone.
[[nodiscard]] Result<FingerPtr> revert_force(const std::filesystem::path& folder);

/// The table of the finger's force model. Errors: it has none, or the table is gone.
[[nodiscard]] Result<ForceTable> stored_force_table(const std::filesystem::path& folder);

/// Options of the training of the finger's force model: split, kind if one was requested, creep.
/// Other options are the defaults. Errors: those of stored_force_table, but for the table itself.
[[nodiscard]] Result<ForceTraining> stored_force_training(const std::filesystem::path& folder);

/// Error: the rows are not of this finger's markers.
[[nodiscard]] Status check_force_markers(const ForceTable& table, const Finger& finger);

}  // namespace alltact
