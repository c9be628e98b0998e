// Eigen's decomposition of symmetric matrices of any size, built once: it takes seconds to compile.
#pragma once

#include <Eigen/Eigenvalues>

namespace alltact {

/// Eigenvalues ascend. Only the lower triangle is read.
[[nodiscard]] Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> symmetric_eigen(
    const Eigen::MatrixXd& matrix);

}  // namespace alltact
