// How much each recorded neighbour counts in the reference of a pose.
#pragma once

#include <vector>

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

inline constexpr int kPoseNeighbours = 8;  ///< as usual: more gain little and cost their share

/// Recorded frames that tell a pose together, and how much each counts.
struct PoseNeighbours {
  std::vector<int> rows;    ///< the first is the nearest
  Eigen::MatrixXd points;   ///< their modes, a row each, px
  Eigen::VectorXd weights;  ///< local_linear_weights()
};

/// Of the rows of `modes` (a row a frame, px) `count` that lie near the pose `place` and on
/// all sides of it. The nearest alone are often frames of one move, in a line, and a regression
/// over a line says nothing of what lies beside it: over drawn fingers the markers of the combined
/// frames lie half as far from those of the pose as with the nearest alone.
/// marker_count: of the layouts that the modes are of. `without` (by row) marks frames that take no
/// part, empty: all do.
[[nodiscard]] PoseNeighbours pose_neighbours(const Eigen::MatrixXd& modes,
                                             const Eigen::VectorXd& place,
                                             int marker_count,
                                             const std::vector<char>& without,
                                             int count = kPoseNeighbours);

}  // namespace alltact
