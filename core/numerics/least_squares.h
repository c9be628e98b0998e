// Linear least squares, as used for all curves.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// The x that minimises |design x - target|, by Householder QR: rounding errors grow with the
/// condition of the design, not with its square as in the normal equations. At least as many rows
/// as columns, columns independent; Chebyshev columns (chebyshev.h) are nearly orthogonal.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& design,
                                            const Eigen::VectorXd& target);

}  // namespace alltact
