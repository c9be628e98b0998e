#include "calibration/lens/lens_fit.h"

#include "calibration/joint/ceres_solver.h"
#include "core/camera/distortion.h"
#include "core/numerics/linear_algebra.h"
#include "core/numerics/median.h"

#include <cassert>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <ceres/ceres.h>
#include <glog/logging.h>
#include <opencv2/calib3d.hpp>

namespace alltact {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using PoseNumbers = Eigen::Matrix<double, 6, 1>;

constexpr double kRobustAt = 3.0;  // standard deviations where Cauchy's weight is a half
constexpr int kMaxRounds = 20;     // of reweighting
// Standard deviations of one coordinate from which a corner is an outlier: by chance one in 25000.
constexpr double kOutlierSigmas = 4.5;
constexpr double kMinSigmaPx = 0.02;  // an outlier lies at least 4.5 of these off
constexpr double kMedianOfRayleigh = 1.1774;

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
  LensProblem(const std::vector<BoardView>& views, const LensFit& start, int coefficients,
              bool free_shape)
      : views_(views),
        coefficients_(coefficients),
        free_shape_(free_shape),
        lens_(start.lens),
        numbers_(lens_numbers(start.lens)),
        shape_(start.shape) {
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
  }

  bool solve(const Job& job) {
    ceres::Problem problem;
    auto* order = new ceres::ParameterBlockOrdering;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      problem.AddResidualBlock(new ViewCost(lens_.model, views_[i], weights_[i], units_), nullptr,
                               numbers_.data(), poses_[i].data(), shape_.data());
      order->AddElementToGroup(poses_[i].data(), 0);
    }
    order->AddElementToGroup(numbers_.data(), 1);
    order->AddElementToGroup(shape_.data(), 1);
    std::vector<int> fixed;
    for (int i = 4 + coefficients_; i < numbers_.size(); ++i) fixed.push_back(i);
    if (!fixed.empty())
      problem.SetManifold(numbers_.data(),
                          new ceres::SubsetManifold(static_cast<int>(numbers_.size()), fixed));
    if (!free_shape_) problem.SetParameterBlockConstant(shape_.data());
    ceres::Solver::Options solver = lens_solver();
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    solver.linear_solver_ordering.reset(order);
    StopWithJob stop(job, ceres::SOLVER_ABORT);
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
      const double* blocks[] = {numbers_.data(), poses_[i].data(), shape_.data()};
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
  const std::vector<BoardView>& views_;
  int coefficients_;
  bool free_shape_;
  CameraParameters lens_;
  Eigen::VectorXd numbers_;  // in the solver's units
  ViewCost::Units units_;
  std::vector<PoseNumbers> poses_;
  Eigen::Vector4d shape_;
  std::vector<std::vector<double>> weights_;
};

Result<LensFit> LensProblem::result() const {
  const auto n = static_cast<int>(numbers_.size());
  const int free = std::min(n, 4 + coefficients_);
  const int shared = free + (free_shape_ ? 4 : 0);
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(shared, shared);
  double sum = 0, freedom = -shared;
  for (std::size_t i = 0; i < views_.size(); ++i) {
    const ViewCost cost(lens_.model, views_[i], weights_[i], units_);
    const int rows = cost.num_residuals();
    Eigen::VectorXd residuals(rows);
    RowMatrix by_lens(rows, n), by_pose(rows, 6), by_shape(rows, 4);
    const double* blocks[] = {numbers_.data(), poses_[i].data(), shape_.data()};
    double* jacobians[] = {by_lens.data(), by_pose.data(), by_shape.data()};
    if (!cost.Evaluate(blocks, residuals.data(), jacobians)) continue;
    const double used =
        static_cast<double>(std::count(weights_[i].begin(), weights_[i].end(), 1.0));
    if (used < 4) continue;
    sum += residuals.squaredNorm();
    freedom += 2 * used - 6;
    Eigen::MatrixXd by_shared(rows, shared);
    by_shared.leftCols(free) = by_lens.leftCols(free);
    if (free_shape_) by_shared.rightCols(4) = by_shape;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(by_pose);
    by_shared.applyOnTheLeft(qr.householderQ().adjoint());
    by_shared.topRows(6).setZero();  // the part that the pose takes up
    information += by_shared.transpose() * by_shared;
  }
  const Eigen::VectorXd scale = information.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  const auto eigen = symmetric_eigen(scale.asDiagonal() * information * scale.asDiagonal());
  if (!(freedom > 0) || !(eigen.eigenvalues()[0] > 1e-12))
    return Error{
        en::say("these views leave the lens undetermined"), "",
        en::say("more views, with the board tilted by 20 to 40 degrees in different directions"),
        ErrorKind::kUndeterminedLens};
  LensFit fit;
  fit.sigma_px = std::sqrt(sum / freedom);
  Eigen::MatrixXd covariance = fit.sigma_px * fit.sigma_px * scale.asDiagonal() *
                               eigen.eigenvectors() *
                               eigen.eigenvalues().cwiseInverse().asDiagonal() *
                               eigen.eigenvectors().transpose() * scale.asDiagonal();
  fit.shape_sd.setZero();
  if (free_shape_) fit.shape_sd = covariance.diagonal().tail<4>().cwiseSqrt();
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

Result<LensFit> fit_lens(const std::vector<BoardView>& views, const LensFit& start,
                         int coefficients, const Job& job, bool free_shape) {
  const auto failed = [&]() -> Error {
    if (job.stop_requested()) return {en::say("stopped before the lens was estimated"), "", ""};
    return {en::say("no lens model could be fitted to the found corners"), "",
            en::say("a flat board of the size given with --board, and views that show it tilted")};
  };
  LensProblem problem(views, start, coefficients, free_shape);
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

double fit_pose(const BoardView& view, const CameraParameters& lens,
                const std::vector<double>& weights, BoardPose& pose, Eigen::Vector4d* free_shape) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const ViewCost::Units units = units_of(lens, view);
  Eigen::VectorXd numbers = lens_numbers(lens);
  numbers.head<4>() /= units.px;
  PoseNumbers pose_numbers = numbers_of(pose, units);
  Eigen::Vector4d shape = Eigen::Vector4d::Zero();
  ceres::Problem problem;
  problem.AddResidualBlock(new ViewCost(lens.model, view, weights, units), nullptr, numbers.data(),
                           pose_numbers.data(), shape.data());
  problem.SetParameterBlockConstant(numbers.data());
  if (free_shape == nullptr) problem.SetParameterBlockConstant(shape.data());
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

namespace {

int coefficient_count(CameraModel model) { return model == CameraModel::kFisheye ? 4 : 5; }

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& w) {
  Eigen::Matrix3d m;
  m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return m;
}

/// sin t / t, (1 - cos t) / t^2 and (t - sin t) / t^3 without loss of precision near 0.
struct Turning {
  double a, b, c;
  explicit Turning(double t2) {
    const double t = std::sqrt(t2);
    if (t < 1e-2) {
      a = 1 - t2 / 6 * (1 - t2 / 20 * (1 - t2 / 42));
      b = 0.5 - t2 / 24 * (1 - t2 / 30 * (1 - t2 / 56));
      c = 1.0 / 6 - t2 / 120 * (1 - t2 / 42 * (1 - t2 / 72));
    } else {
      a = std::sin(t) / t;
      b = (1 - std::cos(t)) / t2;
      c = (t - std::sin(t)) / (t2 * t);
    }
  }
};

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& turn) {
  const Turning turning(turn.squaredNorm());
  const Eigen::Matrix3d w = cross_matrix(turn);
  return Eigen::Matrix3d::Identity() + turning.a * w + turning.b * w * w;
}

/// R(turn + d) is about R(turn) R(J d).
Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& turn) {
  const Turning turning(turn.squaredNorm());
  const Eigen::Matrix3d w = cross_matrix(turn);
  return Eigen::Matrix3d::Identity() - turning.b * w + turning.c * w * w;
}

/// Derivatives of the distorted point by the coefficients; both models are linear in them.
Eigen::Matrix<double, 2, 5> by_coefficients(CameraModel model, const Eigen::Vector2d& p) {
  Eigen::Matrix<double, 2, 5> result = Eigen::Matrix<double, 2, 5>::Zero();
  const double r2 = p.squaredNorm();
  if (model == CameraModel::kFisheye) {
    const double r = std::sqrt(r2);
    if (r == 0) return result;
    const double angle = std::atan(r);
    double power = angle / r;
    for (int k = 0; k < 4; ++k) result.col(k) = p * (power *= angle * angle);
    return result;
  }
  result.col(0) = p * r2;
  result.col(1) = p * (r2 * r2);
  result.col(2) = Eigen::Vector2d(2 * p.x() * p.y(), r2 + 2 * p.y() * p.y());
  result.col(3) = Eigen::Vector2d(r2 + 2 * p.x() * p.x(), 2 * p.x() * p.y());
  result.col(4) = p * (r2 * r2 * r2);
  return result;
}

}  // namespace

Eigen::VectorXd lens_numbers(const CameraParameters& lens) {
  assert(std::ssize(lens.distortion) <= coefficient_count(lens.model));  // fits have no more
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(4 + coefficient_count(lens.model));
  numbers.head<4>() << lens.fx_px, lens.fy_px, lens.cx_px, lens.cy_px;
  for (std::size_t i = 0; i < lens.distortion.size(); ++i)
    numbers[4 + static_cast<int>(i)] = lens.distortion[i];
  return numbers;
}

void set_lens_numbers(CameraParameters& lens, const Eigen::VectorXd& numbers) {
  lens.fx_px = numbers[0], lens.fy_px = numbers[1];
  lens.cx_px = numbers[2], lens.cy_px = numbers[3];
  lens.distortion.assign(numbers.begin() + 4, numbers.end());
}

std::optional<Projection> project_by(CameraModel model, std::span<const double> numbers,
                                     const Eigen::Vector3d& point_mm) {
  if (!(point_mm.z() > 0)) return std::nullopt;
  const Eigen::Vector2d straight = point_mm.head<2>() / point_mm.z();
  const auto coefficients = numbers.subspan(4);
  Eigen::Vector2d seen;
  Eigen::Matrix2d by_straight;
  if (model == CameraModel::kFisheye) {
    const FisheyeDistortion distortion(coefficients);
    seen = distortion.distort(straight);
    by_straight = distortion.jacobian(straight);
  } else {
    const BrownDistortion distortion(coefficients);
    seen = distortion.distort(straight);
    by_straight = distortion.jacobian(straight);
  }
  const Eigen::Vector2d focal(numbers[0], numbers[1]);
  Projection result;
  result.pixel = focal.cwiseProduct(seen) + Eigen::Vector2d(numbers[2], numbers[3]);
  if (!result.pixel.allFinite()) return std::nullopt;
  const int n = coefficient_count(model);
  result.by_numbers.setZero(2, 4 + n);
  result.by_numbers(0, 0) = seen.x();
  result.by_numbers(1, 1) = seen.y();
  result.by_numbers(0, 2) = result.by_numbers(1, 3) = 1;
  result.by_numbers.rightCols(n) =
      focal.asDiagonal() * by_coefficients(model, straight).leftCols(n);
  Eigen::Matrix<double, 2, 3> straight_by_point;
  straight_by_point << 1, 0, -straight.x(), 0, 1, -straight.y();
  result.by_point = focal.asDiagonal() * by_straight * straight_by_point / point_mm.z();
  return result;
}

Eigen::Matrix3d BoardPose::rotation() const { return rotation_of(turn); }

Eigen::Vector3d BoardPose::operator()(const Eigen::Vector3d& board_mm) const {
  return rotation() * board_mm + shift_mm;
}

ViewCost::ViewCost(CameraModel model, const BoardView& view, const std::vector<double>& weights,
                   const Units& units)
    : model_(model), view_(view), weights_(weights), units_(units) {
  set_num_residuals(2 * static_cast<int>(view.pixels.size()));
  *mutable_parameter_block_sizes() = {4 + coefficient_count(model), 6, 4};
}

bool ViewCost::Evaluate(double const* const* parameters, double* residuals,
                        double** jacobians) const {
  const int n = parameter_block_sizes()[0];
  std::array<double, 9> numbers{};
  std::copy_n(parameters[0], n, numbers.begin());
  for (std::size_t i = 0; i < 4; ++i) numbers[i] *= units_.px;
  const Eigen::Map<const Eigen::Vector3d> turn(parameters[1]), shift(parameters[1] + 3);
  const double* shape = parameters[2];
  const Eigen::Matrix3d rotation = rotation_of(turn);
  const Eigen::Matrix3d jacobian = right_jacobian(turn);
  for (std::size_t i = 0; i < view_.pixels.size(); ++i) {
    Eigen::Vector3d board = view_.board_mm[i];
    const Eigen::Vector3d unit_position = (board - units_.board_middle_mm) / units_.board_half_mm;
    const Eigen::Vector3d lift(unit_position.x() * unit_position.x(),
                               unit_position.x() * unit_position.y(),
                               unit_position.y() * unit_position.y());
    board.x() += shape[0] * (board.x() - units_.board_middle_mm.x());
    board.z() += units_.board_half_mm * Eigen::Map<const Eigen::Vector3d>(shape + 1).dot(lift);
    const Eigen::Vector3d point = rotation * board + units_.mm * shift;
    const auto seen = project_by(model_, {numbers.data(), static_cast<std::size_t>(n)}, point);
    if (!seen) return false;
    const double weight = weights_[i];
    const auto row = static_cast<Eigen::Index>(2 * i);
    Eigen::Map<Eigen::Vector2d>(residuals + row) = weight * (seen->pixel - view_.pixels[i]);
    if (jacobians == nullptr) continue;
    if (jacobians[0] != nullptr) {
      Eigen::Map<RowMatrix> out(jacobians[0], num_residuals(), n);
      out.middleRows<2>(row) = weight * seen->by_numbers;
      out.block<2, 4>(row, 0) *= units_.px;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<RowMatrix> out(jacobians[1], num_residuals(), 6);
      out.block<2, 3>(row, 0) =
          -weight * seen->by_point * rotation * cross_matrix(board) * jacobian;
      out.block<2, 3>(row, 3) = weight * units_.mm * seen->by_point;
    }
    if (jacobians[2] != nullptr) {
      Eigen::Map<RowMatrix> out(jacobians[2], num_residuals(), 4);
      const Eigen::Matrix<double, 2, 3> by_board = weight * seen->by_point * rotation;
      out.block<2, 1>(row, 0) = by_board.col(0) * (units_.board_half_mm * unit_position.x());
      out.block<2, 3>(row, 1) = by_board.col(2) * (units_.board_half_mm * lift.transpose());
    }
  }
  return true;
}

namespace {

constexpr double kWorst = std::numeric_limits<double>::infinity();
constexpr std::size_t kMaxViews = 16;  // that the table is tested on

/// Focal lengths in image widths: fields of view from 170 degrees to 6.
constexpr std::array kFocals{0.2, 0.25, 0.3, 0.36, 0.44, 0.53, 0.64, 0.77, 0.93,
                             1.1, 1.4,  1.7, 2.2,  3.0,  4.5,  7.0,  10.0};
constexpr std::array kBends{0.0, -0.12, -0.25, 0.15};

CameraParameters candidate(CameraModel model, cv::Size size, double focal, double bend) {
  CameraParameters lens;
  lens.model = model;
  lens.width_px = size.width, lens.height_px = size.height;
  lens.fx_px = lens.fy_px = focal * size.width;
  lens.cx_px = 0.5 * (size.width - 1), lens.cy_px = 0.5 * (size.height - 1);
  if (model == CameraModel::kBrown && bend != 0) {
    // kBends is the bend at the image's edge; k1 is that over the radius squared.
    const double edge = 0.5 / focal;
    lens.distortion = {bend / (edge * edge)};
  }
  return lens;
}

/// Root mean square distance of projected and seen corners, px; infinite where a corner cannot be
/// seen at all.
double pose_error_px(const BoardView& view, const Camera& camera, const BoardPose& pose) {
  double sum = 0;
  const Eigen::VectorXd numbers = lens_numbers(camera.parameters());
  const Eigen::Matrix3d rotation = pose.rotation();
  const CameraModel model = camera.parameters().model == CameraModel::kFisheye
                                ? CameraModel::kFisheye
                                : CameraModel::kBrown;
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const auto seen = project_by(model, {numbers.data(), static_cast<std::size_t>(numbers.size())},
                                 rotation * view.board_mm[i] + pose.shift_mm);
    if (!seen) return kWorst;
    sum += (seen->pixel - view.pixels[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(view.pixels.size()));
}

/// Median over views of the error of each view's best pose.
double median_error_px(const std::vector<const BoardView*>& views, const Camera& camera) {
  std::vector<double> errors;
  for (const BoardView* view : views) {
    const auto poses = poses_of(*view, camera);
    errors.push_back(poses.empty() ? kWorst : pose_error_px(*view, camera, poses.front()));
  }
  return upper_median(errors);
}

}  // namespace

std::vector<BoardPose> poses_of(const BoardView& view, const Camera& camera) {
  std::vector<cv::Point3d> board;
  std::vector<cv::Point2d> straight;
  for (std::size_t i = 0; i < view.pixels.size(); ++i) {
    const auto ray = camera.unproject(view.pixels[i]);
    if (!ray || ray->direction.head<2>().norm() > 12) continue;  // 85 degrees: unusable here
    board.emplace_back(view.board_mm[i].x(), view.board_mm[i].y(), 0.0);
    straight.emplace_back(ray->direction.x(), ray->direction.y());
  }
  if (board.size() < 6 || 2 * board.size() < view.pixels.size()) return {};
  std::vector<cv::Mat> turns, shifts;
  try {
    cv::solvePnPGeneric(board, straight, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), turns, shifts,
                        false, cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return {};  // the corners lie in a line
  }
  std::vector<std::pair<double, BoardPose>> found;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    BoardPose pose;
    for (int k = 0; k < 3; ++k) {
      pose.turn[k] = turns[i].at<double>(k);
      pose.shift_mm[k] = shifts[i].at<double>(k);
    }
    const double error = pose_error_px(view, camera, pose);
    if (std::isfinite(error)) found.emplace_back(error, pose);
  }
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<BoardPose> poses;
  for (const auto& [error, pose] : found) poses.push_back(pose);
  return poses;
}

Result<CameraParameters> first_lens(const std::vector<BoardView>& views, CameraModel model,
                                    cv::Size size) {
  std::vector<const BoardView*> some;
  const std::size_t step = (views.size() + kMaxViews - 1) / kMaxViews;
  for (std::size_t i = 0; i < views.size(); i += step) some.push_back(&views[i]);
  double best = kWorst;
  CameraParameters lens;
  for (const double focal : kFocals)
    for (const double bend : kBends) {
      if (model == CameraModel::kFisheye && bend != 0) continue;
      const auto camera = Camera::create(candidate(model, size, focal, bend));
      if (!camera) continue;  // folds over
      const double error = median_error_px(some, *camera);
      if (error >= best) continue;
      best = error;
      lens = camera->parameters();
    }
  if (!std::isfinite(best))
    return Error{
        en::say("no lens model explains the found corners"), "",
        en::say("a flat board of the size given with --board; --model fisheye for a lens wider "
                "than 120 degrees"),
        ErrorKind::kUndeterminedLens};
  return lens;
}

}  // namespace alltact
