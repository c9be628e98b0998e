// What the least-squares problems share that Ceres solves.
#pragma once

#include "core/base/job.h"

#include <memory>

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/solver.h>

namespace alltact {

/// Iterates until convergence: the solver's default tolerances stop too early for numbers of many
/// digits. Problems are small and dense; parameters must be scaled to about 1.
[[nodiscard]] inline ceres::Solver::Options solver_settings() {
  ceres::Solver::Options solver;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.max_num_iterations = 300;
  solver.function_tolerance = 1e-18;
  solver.parameter_tolerance = 1e-12;
  solver.gradient_tolerance = 1e-14;
  solver.logging_type = ceres::SILENT;
  solver.num_threads = 1;
  return solver;
}

/// Ends the solver with `result` when its job is requested to stop.
class StopWithJob final : public ceres::IterationCallback {
 public:
  StopWithJob(const Job& job, ceres::CallbackReturnType result) : job_(job), result_(result) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return job_.stop_requested() ? result_ : ceres::SOLVER_CONTINUE;
  }

 private:
  const Job& job_;
  ceres::CallbackReturnType result_;
};

// Reduces a cost function with many residuals and few parameters to one with few residuals.

/// With [J r] = Q [R z] (Householder), the rows of R and z give the solver the same cost, gradient
/// and Gauss-Newton matrix as those of J and r: |z| = |r|, R' z = J' r, R' R = J' J. The
/// transformation is orthogonal and retains the problem's condition. The time for a problem of
/// blocks with few shared parameters then depends on its parameters, not on its samples. Without
/// derivatives all of |r| stands in the last residual; only the cost has a meaning then. Not for
/// loss functions, which need the single residuals.
class CompressedCost final : public ceres::CostFunction {
 public:
  explicit CompressedCost(std::unique_ptr<ceres::CostFunction> full);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  std::unique_ptr<ceres::CostFunction> full_;
  int columns_ = 0;  ///< of all parameter blocks
};

}  // namespace alltact
