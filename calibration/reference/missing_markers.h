// Positions of markers that a finger does not have.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Position of a marker's counterpart on the other side face, mirrored at the face's middle line.
using MirroredPosition = std::function<std::optional<Eigen::Vector2d>(int marker)>;

/// Fills the missing markers of one row of layouts (u0, v0, u1, ..., px). Each comes from a
/// parabola through up to three existing markers of its row, nearest by number. A row of fewer than
/// two uses those of the other side. The same markers are used in every layout; an invisible one
/// (NaN) leaves the missing marker NaN.
void interpolate_missing(const std::vector<int>& missing,
                         const MirroredPosition& mirrored,
                         Eigen::MatrixXd& layouts,
                         Eigen::Index row);

}  // namespace alltact
