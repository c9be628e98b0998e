// Linear least squares, as used for all curves.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace alltact {

/// The x that minimises |design x - target|, by Householder QR: rounding errors grow with the
/// condition of the design, not with its square as in the normal equations. At least as many rows
/// as columns, columns independent; Chebyshev columns (chebyshev.h) are nearly orthogonal.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& design,
                                            const Eigen::VectorXd& target);

// Eigen's decomposition of symmetric matrices of any size, built once: it takes seconds to compile.

/// Eigenvalues ascend. Only the lower triangle is read.
[[nodiscard]] Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> symmetric_eigen(
    const Eigen::MatrixXd& matrix);

// A few points that represent many.

/// Order in which farthest-point sampling takes the rows of `points`: the first row, then always
/// the one farthest from all taken (lowest index on a tie). The first k of them cover the points
/// within twice the best radius that k points can reach. Takes `count` rows, at most all.
[[nodiscard]] std::vector<int> farthest_point_order(const Eigen::MatrixXd& points, int count);

}  // namespace alltact
