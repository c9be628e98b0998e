// A cost function with many residuals and few parameters, handed to the solver as one with few.
#pragma once

#include <memory>

#include <ceres/cost_function.h>

namespace alltact {

/// With [J r] = Q [R z] (Householder), the rows of R and z give the solver the same cost, gradient
/// and Gauss-Newton matrix as those of J and r: |z| = |r|, R' z = J' r, R' R = J' J. Orthogonal, so
/// nothing of the problem's condition is lost, and a problem of blocks that share few parameters
/// then costs what its parameters cost rather than what its samples do. Where no derivatives are
/// asked for, all of |r| stands in the last residual: between two evaluations only the cost means
/// anything. Not for loss functions, which would have to see single residuals.
class CompressedCost final : public ceres::CostFunction {
 public:
  explicit CompressedCost(std::unique_ptr<ceres::CostFunction> whole);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  std::unique_ptr<ceres::CostFunction> whole_;
  int columns_ = 0;  ///< of all parameter blocks
};

}  // namespace alltact
