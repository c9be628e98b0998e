// Weights of the recorded neighbours in the reference of a pose.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Weights of a local linear regression at `query` over the rows of `points` (coordinates in px).
/// They sum to 1 and minimise
///   |query - sum w_i p_i|^2 / ridge_px^2 + sum w_i^2 / k_i,
/// with k_i a kernel that falls with the distance. Inside the neighbours' hull they reproduce the
/// query and everything that is linear in the pose. Where the neighbours lie on a line or the query
/// outside, the ridge limits the weights. It is raised until sum |w_i| <= `max_magnitude`; in the
/// limit the weights are those of a kernel mean.
[[nodiscard]] Eigen::VectorXd local_linear_weights(const Eigen::MatrixXd& points,
                                                   const Eigen::VectorXd& query,
                                                   double ridge_px,
                                                   double max_magnitude);

inline constexpr int kPoseNeighbours = 8;  ///< default: more gain little and cost their share

/// Recorded frames that approximate a pose together, and their weights.
struct PoseNeighbours {
  std::vector<int> rows;    ///< the first is the nearest
  Eigen::MatrixXd points;   ///< their modes, a row each, px
  Eigen::VectorXd weights;  ///< local_linear_weights()
};

/// Selects `count` rows of `modes` (a row per frame, px) near the `pose` and on all sides of it.
/// The nearest frames alone are often from one move, in a line, and a regression over a line does
/// not constrain other directions. Over simulated fingers the markers of the combined frames lie
/// half as far from those of the pose as with the nearest alone.
/// marker_count: of the layouts of the modes. `without` (by row) marks frames to exclude, empty:
/// none.
[[nodiscard]] PoseNeighbours pose_neighbours(const Eigen::MatrixXd& modes,
                                             const Eigen::VectorXd& pose,
                                             int marker_count,
                                             const std::vector<char>& without,
                                             int count = kPoseNeighbours);

}  // namespace alltact
