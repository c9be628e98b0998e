#include "calibration/twin/twin_solver.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Dense>
#include <ceres/ceres.h>

namespace alltact {
namespace {

constexpr double kSingular = 1e-7;  // eigenvalue of the normal equations with a diagonal of 1
constexpr double kMinShare = 0.1;   // part of such an eigenvector

class TwinCost final : public ceres::CostFunction {
 public:
  TwinCost(const TwinModel& model, Eigen::Index unknowns, Eigen::Index residuals) : model_(model) {
    set_num_residuals(static_cast<int>(residuals));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(unknowns));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Eigen::Index n = parameter_block_sizes()[0];
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], n);
    Eigen::VectorXd r(num_residuals());
    Eigen::MatrixXd slopes;
    const bool needs_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    if (!model_(x, r, needs_jacobian ? &slopes : nullptr) || !r.allFinite()) return false;
    Eigen::Map<Eigen::VectorXd>(residuals, r.size()) = r;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    if (needs_jacobian) {
      if (!slopes.allFinite()) return false;
      if (n == 1)
        Eigen::Map<Eigen::VectorXd>(jacobians[0], r.size()) = slopes.col(0);
      else
        Eigen::Map<Rows>(jacobians[0], r.size(), n) = slopes;
    }
    return true;
  }

 private:
  const TwinModel& model_;
};

class StopTwinWithJob final : public ceres::IterationCallback {
 public:
  explicit StopTwinWithJob(const Job& job) : job_(job) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return job_.stop_requested() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const Job& job_;
};

}  // namespace

double TwinSolution::rms() const {
  return std::sqrt(residuals.squaredNorm() / static_cast<double>(residuals.size()));
}

Result<TwinSolution> solve_twin(const TwinModel& model, const TwinUnknowns& unknowns,
                                Eigen::Index residuals, TwinEffort effort, const Job& job) {
  const Eigen::Index n = unknowns.start.size();
  TwinSolution solution;
  solution.x = unknowns.start.cwiseMax(unknowns.low).cwiseMin(unknowns.high);
  ceres::Problem problem;
  problem.AddResidualBlock(new TwinCost(model, n, residuals), nullptr, solution.x.data());
  for (Eigen::Index i = 0; i < n; ++i) {
    problem.SetParameterLowerBound(solution.x.data(), static_cast<int>(i), unknowns.low[i]);
    problem.SetParameterUpperBound(solution.x.data(), static_cast<int>(i), unknowns.high[i]);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = effort.iterations;
  options.function_tolerance = effort.min_gain;
  options.parameter_tolerance = 1e-5;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  StopTwinWithJob stop(job);
  options.callbacks.push_back(&stop);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  solution.residuals.resize(residuals);
  if (!summary.IsSolutionUsable() || !solution.x.allFinite() ||
      !model(solution.x, solution.residuals, &solution.jacobian))
    return Error{en::say("no scene was found with images close to these"), "",
                 en::say("images of one ball, pressed in where the entire contact is visible")};
  for (Eigen::Index i = 0; i < n; ++i) {
    const double margin = 1e-6 * std::max(1.0, unknowns.high[i] - unknowns.low[i]);
    solution.at_bound.push_back(static_cast<char>(solution.x[i] <= unknowns.low[i] + margin ||
                                                  solution.x[i] >= unknowns.high[i] - margin));
  }
  return solution;
}

std::vector<std::optional<double>> clustered_sd(const TwinSolution& solution,
                                                const std::vector<int>& clusters) {
  const Eigen::Index all = solution.x.size();
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < all; ++i)
    if (!solution.at_bound[static_cast<std::size_t>(i)] && solution.jacobian.col(i).norm() > 0)
      free.push_back(i);
  std::vector<std::optional<double>> sd(static_cast<std::size_t>(all));
  const auto n = static_cast<Eigen::Index>(free.size());
  if (n == 0) return sd;
  Eigen::MatrixXd slopes(solution.residuals.size(), n);
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale[i] = 1 / solution.jacobian.col(free[static_cast<std::size_t>(i)]).norm();
    slopes.col(i) = scale[i] * solution.jacobian.col(free[static_cast<std::size_t>(i)]);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(slopes.transpose() * slopes);
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(n);
  std::vector<char> untold(static_cast<std::size_t>(n), 0);
  for (Eigen::Index k = 0; k < n; ++k) {
    if (eigen.eigenvalues()[k] > kSingular) {
      inverse[k] = 1 / eigen.eigenvalues()[k];
      continue;
    }
    for (Eigen::Index i = 0; i < n; ++i)
      if (std::abs(eigen.eigenvectors()(i, k)) > kMinShare) untold[static_cast<std::size_t>(i)] = 1;
  }
  const Eigen::MatrixXd bread =
      eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
  std::map<int, Eigen::VectorXd> pulls;
  for (Eigen::Index row = 0; row < slopes.rows(); ++row) {
    auto [at, is_new] = pulls.try_emplace(clusters[static_cast<std::size_t>(row)]);
    if (is_new) at->second = Eigen::VectorXd::Zero(n);
    at->second += solution.residuals[row] * slopes.row(row).transpose();
  }
  Eigen::MatrixXd meat = Eigen::MatrixXd::Zero(n, n);
  for (const auto& [cluster, pull] : pulls) meat += pull * pull.transpose();
  const auto count = static_cast<double>(pulls.size());
  const Eigen::MatrixXd covariance = bread * meat * bread * (count / std::max(1.0, count - 1));
  for (Eigen::Index i = 0; i < n; ++i)
    if (!untold[static_cast<std::size_t>(i)])
      sd[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])] =
          scale[i] * std::sqrt(std::max(0.0, covariance(i, i)));
  return sd;
}

}  // namespace alltact
