// Trains a force model from a table: compares every kind of regression on held-out blocks.
#pragma once

#include "calibration/force/force_regression.h"
#include "calibration/force/force_split.h"
#include "calibration/force/force_table.h"
#include "core/finger/force_model.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"

#include <optional>
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
                                               const ForceTraining& options,
                                               const Job& job);

/// The table's rows as inputs of a model, without values for hidden markers.
[[nodiscard]] std::vector<ForceInput> force_inputs(const ForceTable& table,
                                                   const std::vector<Eigen::Vector2d>& rest_px);

/// See TrainedForce::label_noise_N, without the bound.
[[nodiscard]] Eigen::VectorXd force_label_noise_N(const ForceTable& table, const ForceFolds& folds);

}  // namespace alltact
