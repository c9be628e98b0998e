// The residuals of the joint fit with their derivatives, for the solver and for the tests that hold
// the derivatives against differences.
#pragma once

#include "calibration/joint_fit.h"
#include "calibration/mapping_curve.h"
#include "calibration/press_samples.h"

#include <vector>

#include <ceres/cost_function.h>

namespace alltact {

/// One press's samples in the zone, and its outline, with their weights for one round.
struct Weighted {
  double ball_radius_mm = 0;
  std::vector<const Sample*> samples;
  std::vector<double> blur_mm;      ///< see blur_mm(), of the round before
  std::vector<double> root_weight;  ///< 1 / sigma with the robust and the zone's weight, 1/mm
  /// By what the robust loss bends less than a square of the same weight, in (0, 1]: its second
  /// derivative over the weight.
  std::vector<double> bend;
  std::vector<const OutlinePoint*> outline;
  std::vector<double> outline_root_weight;  ///< 1 / sigma with the robust weight, 1/rad
};

/// The samples in the zone around a ball, robustly weighted by their residuals, and the outline.
[[nodiscard]] Weighted weigh(const PressSamples& press,
                             const MappingCurve& curve,
                             const Eigen::Vector3d& centre,
                             const JointOptions& options);

/// Brightness: w (M(x) - d(c) - blur), one residual a sample. Parameter blocks: the ball's centre,
/// the mapping's numbers. Keeps references to what it is made from.
class PressCost final : public ceres::CostFunction {
 public:
  PressCost(const Weighted& weighted, const MappingCurve& curve, const JointOptions& options);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  const Weighted& weighted_;
  const MappingCurve& curve_;
  const JointOptions& options_;
};

/// The outline: w (angle between ray and ball centre - asin(R / |c|)), one residual a point.
/// Parameter block: the ball's centre. Keeps a reference.
class OutlineCost final : public ceres::CostFunction {
 public:
  explicit OutlineCost(const Weighted& weighted);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  const Weighted& weighted_;
};

/// The angle by which a ray passes outside the ball (negative: meets it), and its derivative by the
/// centre (may be null). NaN with the camera inside the ball.
[[nodiscard]] double outline_angle_rad(const Eigen::Vector3d& direction,
                                       const Eigen::Vector3d& centre_mm,
                                       double radius_mm,
                                       Eigen::Vector3d* by_centre = nullptr);

}  // namespace alltact
