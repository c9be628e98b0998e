// The pose of the unloaded finger.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// The row nearest to the median of every coordinate, which does not depend on the time spent at
/// either end of the motion. At least one row, finite.
[[nodiscard]] Eigen::Index middle_pose(const Eigen::MatrixXd& layouts);

}  // namespace alltact
