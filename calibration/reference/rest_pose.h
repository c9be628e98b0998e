// The pose in which nothing moves the finger.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// The row nearest to the middle of all: the median of every coordinate, which does not depend on
/// how long the finger stayed at either end of its motion. At least one row, finite.
[[nodiscard]] Eigen::Index middle_pose(const Eigen::MatrixXd& layouts);

}  // namespace alltact
