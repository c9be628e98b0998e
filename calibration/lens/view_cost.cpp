#include "calibration/lens/view_cost.h"

#include "core/camera/distortion.h"

#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

int coefficient_count(CameraModel model) {
  return model == CameraModel::kFisheye ? 4 : 5;
}

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

std::optional<Projection> project_by(CameraModel model,
                                     std::span<const double> numbers,
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

Eigen::Matrix3d BoardPose::rotation() const {
  return rotation_of(turn);
}

Eigen::Vector3d BoardPose::operator()(const Eigen::Vector3d& board_mm) const {
  return rotation() * board_mm + shift_mm;
}

ViewCost::ViewCost(CameraModel model,
                   const BoardView& view,
                   const std::vector<double>& weights,
                   const Units& units)
    : model_(model), view_(view), weights_(weights), units_(units) {
  set_num_residuals(2 * static_cast<int>(view.pixels.size()));
  *mutable_parameter_block_sizes() = {4 + coefficient_count(model), 6, 4};
}

bool ViewCost::Evaluate(double const* const* parameters,
                        double* residuals,
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

}  // namespace alltact
