// The pose in which nothing moves the finger.
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"
#include "core/sensing/markers.h"

#include <Eigen/Core>

namespace alltact {

/// The row nearest to the middle of all: the median of every coordinate, which does not depend on
/// how long the finger stayed at either end of its motion. At least one row, finite.
[[nodiscard]] Eigen::Index middle_pose(const Eigen::MatrixXd& layouts);

/// Makes the pose that these markers show the finger's rest. Error: the finger has no reference, or
/// these are not its markers.
[[nodiscard]] Status set_rest_pose(const Markers& markers, Finger& finger);

}  // namespace alltact
