// Lens and board poses in one least-squares problem: its start, its residuals and its solution.
#pragma once

#include "calibration/lens/board.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/camera/camera.h"

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <ceres/cost_function.h>

namespace alltact {

// One view of a board as residuals with their derivatives, for the solver and for tests that
// compare the derivatives with differences.

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

/// Residuals: weight * (projected - seen), two for each corner, px. Parameter blocks: the lens's
/// numbers, the first four divided by unit_px; the pose, turn then shift divided by unit_mm; the
/// board's shape (see LensFit). The view and the weights must outlive the cost.
class ViewCost final : public ceres::CostFunction {
 public:
  struct Units {
    double px = 1, mm = 1;
    Eigen::Vector3d board_middle_mm = Eigen::Vector3d::Zero();
    double board_half_mm = 1;
  };
  ViewCost(CameraModel model, const BoardView& view, const std::vector<double>& weights,
           const Units& units);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  CameraModel model_;
  const BoardView& view_;
  const std::vector<double>& weights_;
  Units units_;
};

/// A lens and the board's pose in each view. As a start only `lens` and `poses` count.
struct LensFit {
  CameraParameters lens;
  std::vector<BoardPose> poses;  ///< one for each view
  /// Deviation of the board from a plane with square cells: stretch, xx, xy, yy, all without unit.
  /// x is stretched. With s the position from the board's middle in units of half its diagonal, z
  /// is lifted by half the diagonal * (xx sx^2 + xy sx sy + yy sy^2).
  Eigen::Vector4d shape = Eigen::Vector4d::Zero();

  /// of one coordinate of a corner, from the residuals and the number of fitted parameters
  double sigma_px = 0;
  Eigen::MatrixXd covariance;                ///< of lens_numbers(lens); rows of fixed numbers are 0
  Eigen::Vector4d shape_sd;                  ///< of the board's shape; 0 where it was not free
  std::vector<std::vector<double>> weights;  ///< 1: corner used, 0: left out as an outlier
  std::vector<std::vector<double>> errors_px;  ///< of each corner: distance seen to projected

  /// Standard deviation of one of lens_numbers().
  [[nodiscard]] double sd(int number) const { return std::sqrt(covariance(number, number)); }
};

inline constexpr int kAllCoefficients = 5;  ///< of either model, or more

/// `coefficients`: number of free distortion coefficients, the first ones; the others stay.
/// `free_shape`: the board may be stretched and bent, alike in all views.
/// Fits robustly (Cauchy's weights, scale from the median) until convergence, then by plain least
/// squares without outlier corners. The covariance is then valid for Gaussian noise. Errors:
/// stopped, nothing solvable, or a direction of the lens that these views do not determine.
[[nodiscard]] Result<LensFit> fit_lens(const std::vector<BoardView>& views, const LensFit& start,
                                       int coefficients, const Job& job, bool free_shape = false);

/// Fits the pose of one board with a known lens. `weights`: one for each corner. Returns the root
/// of the weighted sum of squares over its degrees of freedom, px of one coordinate; infinite when
/// there is no solution.
double fit_pose(const BoardView& view, const CameraParameters& lens,
                const std::vector<double>& weights, BoardPose& pose,
                Eigen::Vector4d* free_shape = nullptr);

// First values for a lens and for the board's poses, from the corners alone.

/// The possible poses of a board in a view, best first; at most two: a small or distant board looks
/// nearly the same tilted in two directions. Empty when the camera cannot have seen it.
[[nodiscard]] std::vector<BoardPose> poses_of(const BoardView& view, const Camera& camera);

/// Searches a wide table of focal lengths (and for brown of bends) for the lens with which flat
/// boards explain the corners best. The principal point is the middle of the image. It works where
/// a homography of the pixels does not, as with a fisheye. Error: none explains them.
[[nodiscard]] Result<CameraParameters> first_lens(const std::vector<BoardView>& views,
                                                  CameraModel model, cv::Size size);

}  // namespace alltact
