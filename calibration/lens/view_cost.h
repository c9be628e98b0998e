// One view of a board as residuals with their derivatives, for the solver and for tests that
// compare the derivatives with differences.
#pragma once

#include "calibration/lens/board.h"
#include "core/camera/camera.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <ceres/cost_function.h>

namespace alltact {

/// A lens as a vector: fx fy cx cy and all distortion coefficients of its model, missing ones as 0.
/// Brown: 9 numbers, fisheye: 8.
[[nodiscard]] Eigen::VectorXd lens_numbers(const CameraParameters& lens);
void set_lens_numbers(CameraParameters& lens, const Eigen::VectorXd& numbers);

/// The pixel of a point in the camera's frame, by the formulas of core/camera, and its derivatives.
/// Folds of the lens are not checked: a fit may pass through them. nullopt when z <= 0.
struct Projection {
  Eigen::Vector2d pixel;
  Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor, 2, 9> by_numbers;
  Eigen::Matrix<double, 2, 3> by_point;  ///< px / mm
};
[[nodiscard]] std::optional<Projection> project_by(CameraModel model,
                                                   std::span<const double> numbers,
                                                   const Eigen::Vector3d& point_mm);

/// Pose of a board: point_in_camera = R(turn) * point_on_board + shift. `turn` is the axis of the
/// rotation times its angle in rad.
struct BoardPose {
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();
  Eigen::Vector3d shift_mm = Eigen::Vector3d::Zero();

  [[nodiscard]] Eigen::Matrix3d rotation() const;
  [[nodiscard]] Eigen::Vector3d operator()(const Eigen::Vector3d& board_mm) const;
};

/// Deviation of a board from a plane with square cells. x is stretched. With s the position from
/// the board's middle in units of half its diagonal, z is lifted by half the diagonal * (xx sx^2 +
/// xy sx sy + yy sy^2).
struct BoardShape {
  std::array<double, 4> numbers{};  ///< stretch, xx, xy, yy: all without unit
};

/// Residuals: weight * (projected - seen), two for each corner, px. Parameter blocks: the lens's
/// numbers, the first four divided by unit_px; the pose, turn then shift divided by unit_mm; the
/// board's shape. The view and the weights must outlive the cost.
class ViewCost final : public ceres::CostFunction {
 public:
  struct Units {
    double px = 1, mm = 1;
    Eigen::Vector3d board_middle_mm = Eigen::Vector3d::Zero();
    double board_half_mm = 1;
  };
  ViewCost(CameraModel model,
           const BoardView& view,
           const std::vector<double>& weights,
           const Units& units);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  CameraModel model_;
  const BoardView& view_;
  const std::vector<double>& weights_;
  Units units_;
};

}  // namespace alltact
