// Estimates of every member of a cross-validation for its held-out rows.
#pragma once

#include "calibration/force/force_regression.h"
#include "calibration/force/force_split.h"
#include "core/job.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Of one kind of regression.
struct HeldOutForce {
  std::vector<ForceMember> members;  ///< by fold, each trained without it
  Eigen::MatrixXd estimated_N;       ///< of each row by the member that held it out
  Eigen::MatrixXd spread_N;          ///< sd of all members, row by row
};

/// Runs the folds in parallel; the result does not depend on the number of threads. Incomplete
/// where the job is stopped.
[[nodiscard]] HeldOutForce hold_out_force(const std::vector<ForceInput>& filled,
                                          const Eigen::MatrixXd& force_N,
                                          const ForceFolds& folds,
                                          ForceKind kind,
                                          const ForceNetworkOptions& options,
                                          const Job& job);

/// error| / s with s = sqrt(floor^2 + spread^2); floor is the errors' root mean square.
struct ForceErrorScores {
  Eigen::VectorXd floor_N;
  Eigen::MatrixXd score;  ///< one row a frame, at least 0
};
[[nodiscard]] ForceErrorScores error_scores(const HeldOutForce& held_out,
                                            const Eigen::MatrixXd& force_N);

/// The conformal quantile: the ceil((n + 1) level)-th smallest, or the greatest. Values must not be
/// empty.
[[nodiscard]] double conformal_quantile(std::vector<double> values, double level);

/// Fraction of the rows whose score is not above the quantile of all other folds' scores, by axis.
[[nodiscard]] Eigen::VectorXd covered_part(const Eigen::MatrixXd& score,
                                           const ForceFolds& folds,
                                           double level);

}  // namespace alltact
