// A force model from a table: every kind of regression held against the others on blocks that it
// has not seen.
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
  /// Which is kept; nullopt: the simplest that no other is better than (below).
  std::optional<ForceKind> kind;
  double creep_s = 0;  ///< time of the running mean that creep is told by; 0: no input. Needs times
  ForceNetworkOptions network;
  std::uint64_t seed = 1;
  /// Without the random split and the shuffled forces, which are only to be shown.
  bool comparison_only = false;
};

/// Errors of one kind of regression on rows that it was not trained with, by axis.
struct ForceComparison {
  ForceKind kind = ForceKind::kMean;
  Eigen::VectorXd mae_N, rmse_N;
  Eigen::VectorXd r2;            ///< against the mean of all rows; below 0: worse than that
  double relative = 0;           ///< mean over axes of mae / sd of the force
  Eigen::VectorXd random_mae_N;  ///< by the random split: too kind. Of no size: not asked for
  /// Mean over axes with the forces in an order drawn at random; above 0 the split leaks.
  std::optional<double> shuffled_r2;
};

struct TrainedForce {
  ForceModel model;
  std::vector<ForceComparison> comparison;  ///< mean, ridge, quadratic, network
  Eigen::MatrixXd held_out_N;               ///< forces that the kept kind told of rows not seen
  /// Part of the rows within their interval, that interval made without their block, by axis.
  Eigen::VectorXd covered_90, covered_95;
  /// Sd of the gauge's own noise, at most: by second differences of rows that follow each other
  /// (Rice 1984; Gasser, Sroka, Jennen-Steinmetz 1986), and not above the held-out error.
  Eigen::VectorXd label_noise_N;
  std::vector<Message> remarks;

  [[nodiscard]] const ForceComparison& of(ForceKind kind) const {
    return comparison[static_cast<std::size_t>(kind) - 1];
  }
};

/// Kept is the simplest (mean, ridge, quadratic, network in this order) to which no later one is
/// better by more than 1 % and the standard error of their difference over folds.
///   rest_px: where displacements count from; empty: the mean of the rows
/// Errors: those of force_folds; creep without times; stopped.
[[nodiscard]] Result<TrainedForce> train_force(const ForceTable& table,
                                               const std::vector<Eigen::Vector2d>& rest_px,
                                               const ForceTraining& options,
                                               const Job& job);

/// The table's rows as a model sees them, hidden markers not filled in yet.
[[nodiscard]] std::vector<ForceInput> force_inputs(const ForceTable& table,
                                                   const std::vector<Eigen::Vector2d>& rest_px);

/// See TrainedForce::label_noise_N, without the bound.
[[nodiscard]] Eigen::VectorXd force_label_noise_N(const ForceTable& table, const ForceFolds& folds);

}  // namespace alltact
