// How much each recorded neighbour counts in the reference of a pose.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// Weights of a local linear regression at `query` over the rows of `points` (coordinates in px):
/// they sum to 1 and minimise
///   |query - sum w_i p_i|^2 / ridge_px^2 + sum w_i^2 / k_i,
/// k_i a kernel that falls with the distance. Inside the neighbours' hull that reproduces the query
/// and with it everything that changes linearly with the pose; where the neighbours lie on a line
/// or the query outside, the ridge keeps the weights small, and it is raised until sum |w_i| <=
/// `most`: in the limit they are those of a kernel mean led by the nearest.
[[nodiscard]] Eigen::VectorXd local_linear_weights(const Eigen::MatrixXd& points,
                                                   const Eigen::VectorXd& query,
                                                   double ridge_px,
                                                   double most);

}  // namespace alltact
