// Trains a force model: compares every kind of regression on held-out blocks of a table, and saves
// the selected one in a finger.
#pragma once

#include "calibration/force/force_regression.h"
#include "calibration/force/force_table.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/finger/force_model.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct ForceTraining {
  ForceSplit split = ForceSplit::kBlock;
  /// Which kind is selected; nullopt: the simplest that no other surpasses (below).
  std::optional<ForceKind> kind;
  /// time constant of the running mean that gives creep; 0: no input. Needs times
  double creep_s = 0;
  ForceNetworkOptions network;
  std::uint64_t seed = 1;
  /// Without the random split and the shuffled forces, which serve for comparison only.
  bool comparison_only = false;
};

/// Errors of one kind of regression on held-out rows, by axis.
struct ForceComparison {
  ForceKind kind = ForceKind::kMean;
  Eigen::VectorXd mae_N, rmse_N;
  Eigen::VectorXd r2;            ///< against the mean of all rows; below 0: worse than that
  double relative = 0;           ///< mean over axes of mae / sd of the force
  Eigen::VectorXd random_mae_N;  ///< by the random split: too optimistic. Empty: not requested
  /// Mean over axes with the forces in random order; above 0 the split leaks.
  std::optional<double> shuffled_r2;
};

struct TrainedForce {
  ForceModel model;
  std::vector<ForceComparison> comparison;  ///< mean, ridge, quadratic, network
  Eigen::MatrixXd held_out_N;  ///< forces that the selected kind estimated for held-out rows
  /// Fraction of the rows within their interval, which was made without their block, by axis.
  Eigen::VectorXd covered_90, covered_95;
  /// Upper limit of the sd of the gauge's own noise: by second differences of consecutive rows
  /// (Rice 1984; Gasser, Sroka, Jennen-Steinmetz 1986), and not above the held-out error.
  Eigen::VectorXd label_noise_N;
  std::vector<Message> remarks;

  [[nodiscard]] const ForceComparison& of(ForceKind kind) const {
    return comparison[static_cast<std::size_t>(kind) - 1];
  }
};

/// Selects the simplest (mean, ridge, quadratic, network in this order) to which no later one is
/// better by more than 1 % and the standard error of their difference over folds.
///   rest_px: where displacements count from; empty: the mean of the rows
/// Errors: those of force_folds; creep without times; stopped.
[[nodiscard]] Result<TrainedForce> train_force(const ForceTable& table,
                                               const std::vector<Eigen::Vector2d>& rest_px,
                                               const ForceTraining& options, const Job& job);

/// The table's rows as inputs of a model, without values for hidden markers.
[[nodiscard]] std::vector<ForceInput> force_inputs(const ForceTable& table,
                                                   const std::vector<Eigen::Vector2d>& rest_px);

/// See TrainedForce::label_noise_N, without the bound.
[[nodiscard]] Eigen::VectorXd force_label_noise_N(const ForceTable& table, const ForceFolds& folds);

// Trains the force model of a finger on disk, and restores the previous one.

/// Trains a model for the finger and changes nothing. Errors: a finger without markers or without
/// reference; a table of other markers; those of train_force.
[[nodiscard]] Result<TrainedForce> train_for_finger(const Finger& finger, const ForceTable& table,
                                                    const ForceTraining& options, const Job& job);
/// Saves a model of train_for_finger() in the finger, as force/model-HASH.json with its table. Both
/// are named after their content, so an earlier model stays, and revert_force() returns to it. The
/// model's record gets the table's name. Errors, after which the finger is unchanged: those of
/// FingerStore::update.
[[nodiscard]] Status install_force(const std::filesystem::path& folder, const ForceTable& table,
                                   TrainedForce& trained);

/// Both, while the finger is locked. Errors, after which the finger is unchanged: those of both;
/// another process works on the finger.
[[nodiscard]] Result<TrainedForce> train_finger_force(const std::filesystem::path& folder,
                                                      const ForceTable& table,
                                                      const ForceTraining& options, const Job& job);

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
