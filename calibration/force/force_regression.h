// The regressions of a force model, and their inputs from a frame.
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
  int members = 2;   ///< networks of each fold, averaged
  std::uint64_t seed = 1;
};

/// Learns the range of a table's frames; fills in hidden markers in `inputs`, which have at least 2
/// frames.
[[nodiscard]] ForceRange learn_force_range(std::vector<ForceInput>& inputs);

/// The inputs of a regression of this kind, learnt from these rows of the filled inputs. They are
/// the principal components of the standardised displacements (sd plus 0.2 px of noise), flags of
/// markers that are seen in some frames and hidden in others, the position where it is known, and
/// creep of the first three components.
[[nodiscard]] ForceBasis learn_force_basis(const std::vector<ForceInput>& filled,
                                           const std::vector<Eigen::Index>& rows, ForceKind kind);

/// F = W z + b with the prior W ~ N(0, s^2 / lambda), one lambda for all axes, at the greatest
/// marginal likelihood (MacKay, "Bayesian interpolation", Neural Computation 1992). Correlated rows
/// make that estimate overconfident, so W is the mean over lambda from a tenth of it to ten times
/// it.
///   z: one row a frame; force: one column an axis
[[nodiscard]] ForceRegressor fit_force_ridge(const Eigen::MatrixXd& z,
                                             const Eigen::MatrixXd& force_N);

/// Two hidden layers with max(0, .), least squares by AdamW (Loshchilov and Hutter, "Decoupled
/// weight decay regularization", ICLR 2019). The learning rate falls to 0 along a cosine. The same
/// seed gives the same bytes on any number of threads.
[[nodiscard]] ForceRegressor fit_force_network(const Eigen::MatrixXd& z,
                                               const Eigen::MatrixXd& force_N,
                                               const ForceNetworkOptions& options,
                                               std::uint32_t which);

/// Fits a member of this kind to these rows. `which` separates its random numbers from other
/// members'.
[[nodiscard]] ForceMember fit_force_member(const std::vector<ForceInput>& filled,
                                           const Eigen::MatrixXd& force_N,
                                           const std::vector<Eigen::Index>& rows, ForceKind kind,
                                           const ForceNetworkOptions& options, std::uint32_t which);

}  // namespace alltact
