// Where a dot would be that a finger does not have.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Where a marker's counterpart on the other side face lies, mirrored at the face's middle line.
using MirroredPlace = std::function<std::optional<Eigen::Vector2d>(int marker)>;

/// Fills the missing markers of one row of layouts (u0, v0, u1, ..., px) from up to three existing
/// ones of their row that are nearest by number, on a parabola through these; in a row of fewer
/// than two from those of the other side. The same ones are used in every layout; one that is not
/// seen (NaN) leaves the missing marker NaN.
void place_missing(const std::vector<int>& missing,
                   const MirroredPlace& mirrored,
                   Eigen::MatrixXd& layouts,
                   Eigen::Index row);

}  // namespace alltact
