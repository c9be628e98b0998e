// Linear least squares: the one way it is done for curves.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// The x that makes |design x - target| least, by Householder QR: roundings grow with the condition
/// of the design, not with its square as in the normal equations. At least as many rows as columns,
/// columns independent; Chebyshev columns (chebyshev.h) are nearly orthogonal.
[[nodiscard]] Eigen::VectorXd least_squares(const Eigen::MatrixXd& design,
                                            const Eigen::VectorXd& target);

}  // namespace alltact
