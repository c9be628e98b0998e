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
  int coefficients = 5;     ///< of distortion that are free, the first ones; the others stay
  bool free_shape = false;  ///< the board may be stretched and bent, the same in all views
};

/// A lens with where each board stood. As a start only `lens` and `poses` count.
struct LensFit {
  CameraParameters lens;
  std::vector<BoardPose> poses;  ///< one for each view
  BoardShape shape;

  double sigma_px = 0;  ///< of one coordinate of a corner, from the residuals and what was fitted
  Eigen::MatrixXd covariance;  ///< of lens_numbers(lens); rows of what stayed fixed are 0
  Eigen::Vector4d shape_sd;    ///< of the board's shape; 0 where it was not free
  std::vector<std::vector<double>> weights;    ///< 1: corner used, 0: left out as an outlier
  std::vector<std::vector<double>> errors_px;  ///< of each corner: distance seen to projected

  /// Standard deviation of one of lens_numbers().
  [[nodiscard]] double sd(int number) const { return std::sqrt(covariance(number, number)); }
};

/// Distance, in standard deviations of one coordinate, from which a corner is an outlier: by chance
/// one in 25000 lies further.
inline constexpr double kOutlierSigmas = 4.5;

/// Robust (Cauchy's weights, scale from the median) until settled, then plain least squares on the
/// corners that are no outliers, so that the covariance is true for noise that is Gaussian.
/// Errors: stopped, nothing solvable, or a direction of the lens that these views do not show.
[[nodiscard]] Result<LensFit> fit_lens(const std::vector<BoardView>& views,
                                       const LensFit& start,
                                       const LensFitOptions& options,
                                       const Job& job);

/// Where one board stands, the lens being known. `weights`: one for each corner. Returns the root
/// of the weighted sum of squares over its degrees of freedom, px of one coordinate; infinite when
/// there is no solution.
double fit_pose(const BoardView& view,
                const CameraParameters& lens,
                const std::vector<double>& weights,
                BoardPose& pose,
                BoardShape* free_shape = nullptr);

}  // namespace alltact
