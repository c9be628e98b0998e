// The regressions that a force model may consist of, and what they see of a frame.
#pragma once

#include "core/finger/force_model.h"

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Of the network with two hidden layers.
struct ForceNetworkOptions {
  int hidden_1 = 32, hidden_2 = 16;
  int steps = 4000;  ///< of Adam, 32 rows each: at most these, and at most 100 passes
  int members = 2;   ///< networks of each fold, which are averaged
  std::uint64_t seed = 1;
};

/// What is known of a table's frames as a whole; fills in what is hidden in `inputs`, which have at
/// least 2 frames.
[[nodiscard]] ForceRange learn_force_range(std::vector<ForceInput>& inputs);

/// What a regression of this kind sees, learnt from these rows of the filled inputs: standardised
/// displacements' principal components (sd with 0.2 px of noise beside), flags of markers that are
/// seen in some frames and hidden in others, the place where it is known, creep of the first three
/// components.
[[nodiscard]] ForceBasis learn_force_basis(const std::vector<ForceInput>& filled,
                                           const std::vector<Eigen::Index>& rows,
                                           ForceKind kind);

/// F = W z + b with the prior W ~ N(0, s^2 / lambda), one lambda for all axes, at the greatest
/// marginal likelihood (MacKay, "Bayesian interpolation", Neural Computation 1992). Rows that hang
/// together make that too sure: W is the mean over lambda from a tenth of it to ten times as much.
///   z: one row a frame; force: one column an axis
[[nodiscard]] ForceRegressor fit_force_ridge(const Eigen::MatrixXd& z,
                                             const Eigen::MatrixXd& force_N);

/// Two hidden layers with max(0, .), least squares by AdamW (Loshchilov and Hutter, "Decoupled
/// weight decay regularization", ICLR 2019) with a rate that falls to 0 along a cosine. The same
/// bytes for the same seed on any number of threads.
[[nodiscard]] ForceRegressor fit_force_network(const Eigen::MatrixXd& z,
                                               const Eigen::MatrixXd& force_N,
                                               const ForceNetworkOptions& options,
                                               std::uint32_t which);

/// A member of this kind, learnt from these rows. `which` tells its draws from other members'.
[[nodiscard]] ForceMember fit_force_member(const std::vector<ForceInput>& filled,
                                           const Eigen::MatrixXd& force_N,
                                           const std::vector<Eigen::Index>& rows,
                                           ForceKind kind,
                                           const ForceNetworkOptions& options,
                                           std::uint32_t which);

}  // namespace alltact
