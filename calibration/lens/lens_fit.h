// Lens and board poses in one least-squares problem.
#pragma once

#include "calibration/lens/board.h"
#include "calibration/lens/view_cost.h"
#include "core/camera/camera.h"
#include "core/job.h"
#include "core/result.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

struct LensFitOptions {
  /// number of free distortion coefficients, the first ones; the others stay
  int coefficients = 5;
  bool free_shape = false;  ///< the board may be stretched and bent, alike in all views
};

/// A lens and the board's pose in each view. As a start only `lens` and `poses` count.
struct LensFit {
  CameraParameters lens;
  std::vector<BoardPose> poses;  ///< one for each view
  BoardShape shape;

  /// of one coordinate of a corner, from the residuals and the number of fitted parameters
  double sigma_px = 0;
  Eigen::MatrixXd covariance;                ///< of lens_numbers(lens); rows of fixed numbers are 0
  Eigen::Vector4d shape_sd;                  ///< of the board's shape; 0 where it was not free
  std::vector<std::vector<double>> weights;  ///< 1: corner used, 0: left out as an outlier
  std::vector<std::vector<double>> errors_px;  ///< of each corner: distance seen to projected

  /// Standard deviation of one of lens_numbers().
  [[nodiscard]] double sd(int number) const { return std::sqrt(covariance(number, number)); }
};

/// Distance, in standard deviations of one coordinate, from which a corner is an outlier. By chance
/// one in 25000 lies further.
inline constexpr double kOutlierSigmas = 4.5;

/// Fits robustly (Cauchy's weights, scale from the median) until convergence, then by plain least
/// squares without outlier corners. The covariance is then valid for Gaussian noise. Errors:
/// stopped, nothing solvable, or a direction of the lens that these views do not determine.
[[nodiscard]] Result<LensFit> fit_lens(const std::vector<BoardView>& views,
                                       const LensFit& start,
                                       const LensFitOptions& options,
                                       const Job& job);

/// Fits the pose of one board with a known lens. `weights`: one for each corner. Returns the root
/// of the weighted sum of squares over its degrees of freedom, px of one coordinate; infinite when
/// there is no solution.
double fit_pose(const BoardView& view,
                const CameraParameters& lens,
                const std::vector<double>& weights,
                BoardPose& pose,
                BoardShape* free_shape = nullptr);

}  // namespace alltact
