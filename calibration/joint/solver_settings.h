// Settings of all least-squares problems here.
#pragma once

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

}  // namespace alltact
