// Reduces a cost function with many residuals and few parameters to one with few residuals.
#pragma once

#include <memory>

#include <ceres/cost_function.h>

namespace alltact {

/// With [J r] = Q [R z] (Householder), the rows of R and z give the solver the same cost, gradient
/// and Gauss-Newton matrix as those of J and r: |z| = |r|, R' z = J' r, R' R = J' J. The
/// transformation is orthogonal and retains the problem's condition. The time for a problem of
/// blocks with few shared parameters then depends on its parameters, not on its samples. Without
/// derivatives all of |r| stands in the last residual; only the cost has a meaning then. Not for
/// loss functions, which need the single residuals.
class CompressedCost final : public ceres::CostFunction {
 public:
  explicit CompressedCost(std::unique_ptr<ceres::CostFunction> full);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  std::unique_ptr<ceres::CostFunction> full_;
  int columns_ = 0;  ///< of all parameter blocks
};

}  // namespace alltact
