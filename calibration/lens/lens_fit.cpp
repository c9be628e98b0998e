#include "calibration/lens/lens_fit.h"

#include "calibration/joint/solver_settings.h"
#include "core/numerics/median.h"
#include "core/numerics/symmetric_eigen.h"

#include <limits>

#include <Eigen/Dense>
#include <ceres/ceres.h>
#include <glog/logging.h>

namespace alltact {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using PoseNumbers = Eigen::Matrix<double, 6, 1>;

constexpr double kRobustAt = 3.0;     // standard deviations where Cauchy's weight is a half
constexpr int kMaxRounds = 20;        // of reweighting
constexpr double kMinSigmaPx = 0.02;  // an outlier lies at least 4.5 of these off
constexpr double kMedianOfRayleigh = 1.1774;

class StopWithJob final : public ceres::IterationCallback {
 public:
  explicit StopWithJob(const Job& job) : job_(job) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return job_.stop_requested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

 private:
  const Job& job_;
};

ViewCost::Units units_of(const CameraParameters& lens, const BoardView& view) {
  ViewCost::Units units;
  units.px = lens.width_px;
  Eigen::Vector3d low = view.board_mm.front(), high = low;
  for (const Eigen::Vector3d& point_mm : view.board_mm) {
    low = low.cwiseMin(point_mm);
    high = high.cwiseMax(point_mm);
  }
  units.board_middle_mm = 0.5 * (low + high);
  units.board_half_mm = 0.5 * (high - low).norm();
  units.mm = units.board_half_mm;
  return units;
}

PoseNumbers numbers_of(const BoardPose& pose, const ViewCost::Units& units) {
  PoseNumbers numbers;
  numbers << pose.turn, pose.shift_mm / units.mm;
  return numbers;
}

BoardPose pose_of(const PoseNumbers& numbers, const ViewCost::Units& units) {
  return {numbers.head<3>(), numbers.tail<3>() * units.mm};
}

ceres::Solver::Options lens_solver() {
  // Silences the solver's log: rejected steps do not concern the user, and errors are reported
  // here.
  FLAGS_minloglevel = google::GLOG_FATAL;
  return solver_settings();
}

/// The problem in the solver's units, with the conversions.
class LensProblem {
 public:
  LensProblem(const std::vector<BoardView>& views, const LensFit& start, LensFitOptions options)
      : views_(views), options_(options), lens_(start.lens), numbers_(lens_numbers(start.lens)) {
    // All views share one board: the widest view gives its middle and size.
    std::size_t widest = 0;
    for (std::size_t i = 0; i < views.size(); ++i)
      if (views[i].board_mm.size() > views[widest].board_mm.size()) widest = i;
    units_ = units_of(lens_, views[widest]);
    numbers_.head<4>() /= units_.px;
    for (std::size_t i = 0; i < views.size(); ++i) {
      poses_.push_back(numbers_of(start.poses[i], units_));
      weights_.emplace_back(views[i].pixels.size(), 1.0);
    }
    shape_ = start.shape;
  }

  bool solve(const Job& job) {
    ceres::Problem problem;
    auto* order = new ceres::ParameterBlockOrdering;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      problem.AddResidualBlock(new ViewCost(lens_.model, views_[i], weights_[i], units_),
                               nullptr,
                               numbers_.data(),
                               poses_[i].data(),
                               shape_.numbers.data());
      order->AddElementToGroup(poses_[i].data(), 0);
    }
    order->AddElementToGroup(numbers_.data(), 1);
    order->AddElementToGroup(shape_.numbers.data(), 1);
    if (const auto fixed = fixed_numbers(); !fixed.empty())
      problem.SetManifold(numbers_.data(),
                          new ceres::SubsetManifold(static_cast<int>(numbers_.size()), fixed));
    if (!options_.free_shape) problem.SetParameterBlockConstant(shape_.numbers.data());
    ceres::Solver::Options solver = lens_solver();
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    solver.linear_solver_ordering.reset(order);
    StopWithJob stop(job);
    solver.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    return summary.IsSolutionUsable() && numbers_.allFinite();
  }

  /// Distances between seen and projected corners; infinite where a corner cannot be seen.
  [[nodiscard]] std::vector<std::vector<double>> errors_px() const {
    std::vector<std::vector<double>> errors;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      const std::vector<double> ones(views_[i].pixels.size(), 1.0);
      const ViewCost cost(lens_.model, views_[i], ones, units_);
      Eigen::VectorXd residuals(cost.num_residuals());
      const double* blocks[] = {numbers_.data(), poses_[i].data(), shape_.numbers.data()};
      const bool seen = cost.Evaluate(blocks, residuals.data(), nullptr);
      auto& of_view = errors.emplace_back(ones.size(), std::numeric_limits<double>::infinity());
      for (std::size_t k = 0; seen && k < ones.size(); ++k)
        of_view[k] = residuals.segment<2>(static_cast<Eigen::Index>(2 * k)).norm();
    }
    return errors;
  }

  std::vector<std::vector<double>>& weights() { return weights_; }

  /// The solution, with sigma and covariance. Each pose is eliminated from its view's derivatives.
  Result<LensFit> result() const;

 private:
  [[nodiscard]] std::vector<int> fixed_numbers() const {
    std::vector<int> fixed;
    for (int i = 4 + options_.coefficients; i < numbers_.size(); ++i) fixed.push_back(i);
    return fixed;
  }

  const std::vector<BoardView>& views_;
  LensFitOptions options_;
  CameraParameters lens_;
  Eigen::VectorXd numbers_;  // in the solver's units
  ViewCost::Units units_;
  std::vector<PoseNumbers> poses_;
  BoardShape shape_;
  std::vector<std::vector<double>> weights_;
};

Result<LensFit> LensProblem::result() const {
  const auto n = static_cast<int>(numbers_.size());
  const int free = std::min(n, 4 + options_.coefficients);
  const int shared = free + (options_.free_shape ? 4 : 0);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(shared, shared);
  double sum = 0, freedom = -shared;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const ViewCost cost(lens_.model, views_[i], weights_[i], units_);
    const int rows = cost.num_residuals();
    Eigen::VectorXd residuals(rows);
    RowMatrix by_lens(rows, n), by_pose(rows, 6), by_shape(rows, 4);
    const double* blocks[] = {numbers_.data(), poses_[i].data(), shape_.numbers.data()};
    double* jacobians[] = {by_lens.data(), by_pose.data(), by_shape.data()};
    if (!cost.Evaluate(blocks, residuals.data(), jacobians)) continue;
    const double used =
        static_cast<double>(std::count(weights_[i].begin(), weights_[i].end(), 1.0));
    if (used < 4) continue;
    sum += residuals.squaredNorm();
    freedom += 2 * used - 6;
    Eigen::MatrixXd by_shared(rows, shared);
    by_shared.leftCols(free) = by_lens.leftCols(free);
    if (options_.free_shape) by_shared.rightCols(4) = by_shape;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(by_pose);
    by_shared.applyOnTheLeft(qr.householderQ().adjoint());
    by_shared.topRows(6).setZero();  // the part that the pose takes up
    information += by_shared.transpose() * by_shared;
  }
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const auto eigen = symmetric_eigen(scale.asDiagonal() * information * scale.asDiagonal());
  if (!(freedom > 0) || !(eigen.eigenvalues()[0] > 1e-12))
    return Error{
        en::say("these views leave the lens undetermined"),
        "",
        en::say("more views, with the board tilted by 20 to 40 degrees in different directions")};
  LensFit fit;
  fit.sigma_px = std::sqrt(sum / freedom);
  Eigen::MatrixXd covariance = fit.sigma_px * fit.sigma_px * scale.asDiagonal() *
                               eigen.eigenvectors() *
                               eigen.eigenvalues().cwiseInverse().asDiagonal() *
                               eigen.eigenvectors().transpose() * scale.asDiagonal();
  fit.shape_sd.setZero();
  if (options_.free_shape) fit.shape_sd = covariance.diagonal().tail<4>().cwiseSqrt();
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(n);
  unit.head<4>().setConstant(units_.px);
  fit.covariance.setZero(n, n);
  fit.covariance.topLeftCorner(free, free) = unit.head(free).asDiagonal() *
                                             covariance.topLeftCorner(free, free) *
                                             unit.head(free).asDiagonal();
  fit.lens = lens_;
  set_lens_numbers(fit.lens, unit.cwiseProduct(numbers_));
  for (const PoseNumbers& pose : poses_) fit.poses.push_back(pose_of(pose, units_));
  fit.shape = shape_;
  fit.weights = weights_;
  fit.errors_px = errors_px();
  return fit;
}

double sigma_of(const std::vector<std::vector<double>>& errors) {
  std::vector<double> all;
  for (const auto& of_view : errors) all.insert(all.end(), of_view.begin(), of_view.end());
  return upper_median(all) / kMedianOfRayleigh;
}

/// False when nothing can be solved.
bool solve_robustly(LensProblem& problem, const Job& job) {
  if (!problem.solve(job)) return false;
  double before = 0;
  for (int round = 0; round < kMaxRounds; ++round) {
    const auto errors = problem.errors_px();
    const double sigma = std::max(sigma_of(errors), 1e-6);
    if (!std::isfinite(sigma)) return false;
    if (std::abs(sigma - before) < 1e-3 * sigma) return true;
    before = sigma;
    for (std::size_t i = 0; i < errors.size(); ++i)
      for (std::size_t k = 0; k < errors[i].size(); ++k)
        problem.weights()[i][k] = 1 / std::hypot(1.0, errors[i][k] / (kRobustAt * sigma));
    if (!problem.solve(job)) return false;
  }
  return true;
}

}  // namespace

Result<LensFit> fit_lens(const std::vector<BoardView>& views,
                         const LensFit& start,
                         const LensFitOptions& options,
                         const Job& job) {
  const auto failed = [&]() -> Error {
    if (job.stop_requested()) return {en::say("stopped before the lens was known"), "", ""};
    return {en::say("no lens could be fitted to the corners that were found"),
            "",
            en::say("a flat board of the size given with --board, and views that show it tilted")};
  };
  LensProblem problem(views, start, options);
  if (!solve_robustly(problem, job)) return failed();
  auto before = problem.weights();
  constexpr int kMaxSorts = 5;
  for (int sort = 0; sort < kMaxSorts; ++sort) {
    const auto errors = problem.errors_px();
    const double limit = kOutlierSigmas * std::max(sigma_of(errors), kMinSigmaPx);
    for (std::size_t i = 0; i < errors.size(); ++i)
      for (std::size_t k = 0; k < errors[i].size(); ++k)
        problem.weights()[i][k] = errors[i][k] <= limit ? 1.0 : 0.0;
    if (problem.weights() == before) break;
    before = problem.weights();
    if (!problem.solve(job)) return failed();
  }
  return problem.result();
}

double fit_pose(const BoardView& view,
                const CameraParameters& lens,
                const std::vector<double>& weights,
                BoardPose& pose,
                BoardShape* free_shape) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const ViewCost::Units units = units_of(lens, view);
  Eigen::VectorXd numbers = lens_numbers(lens);
  numbers.head<4>() /= units.px;
  PoseNumbers pose_numbers = numbers_of(pose, units);
  BoardShape shape;
  ceres::Problem problem;
  problem.AddResidualBlock(new ViewCost(lens.model, view, weights, units),
                           nullptr,
                           numbers.data(),
                           pose_numbers.data(),
                           shape.numbers.data());
  problem.SetParameterBlockConstant(numbers.data());
  if (free_shape == nullptr) problem.SetParameterBlockConstant(shape.numbers.data());
  const ceres::Solver::Options solver = lens_solver();
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  const double used = static_cast<double>(
      std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0; }));
  const double freedom = 2 * used - 6 - (free_shape != nullptr ? 4 : 0);
  if (!summary.IsSolutionUsable() || !(freedom > 0)) return kNone;
  pose = pose_of(pose_numbers, units);
  if (free_shape != nullptr) *free_shape = shape;
  return std::sqrt(2 * summary.final_cost / freedom);
}

}  // namespace alltact
