// How every least-squares problem here is solved: one place for what "solved" means.
#pragma once

#include <ceres/solver.h>

namespace alltact {

/// Iterates until nothing changes any more: the solver's own tolerances stop far too early for
/// numbers that are to be trusted to many digits. Problems are small and dense; parameters are to
/// be scaled to about 1.
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
