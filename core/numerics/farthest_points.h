// A few points that represent many.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Order in which farthest-point sampling takes the rows of `points`: the first row, then always
/// the one farthest from all taken (lowest index on a tie). The first k of them cover the points
/// within twice the best radius that k points can reach. Takes `count` rows, at most all.
[[nodiscard]] std::vector<int> farthest_point_order(const Eigen::MatrixXd& points, int count);

}  // namespace alltact
