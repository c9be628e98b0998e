// The residuals of the joint fit with their derivatives, for the solver and for the tests that hold
// the derivatives against differences.
#pragma once

#include "calibration/joint/joint_fit.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/joint/step_press.h"
#include "calibration/presses/press_samples.h"

#include <optional>
#include <vector>

#include <ceres/cost_function.h>

namespace alltact {

/// One press's samples in the zone, and its outline, with their weights for one round.
struct Weighted {
  double ball_radius_mm = 0;
  std::vector<const Sample*> samples;
  std::vector<double> blur_mm;      ///< see blur_mm(), of the round before
  std::vector<double> slope_mm;     ///< dM/dx at the ball's depth, of the round before
  std::vector<double> root_weight;  ///< 1 / sigma with the robust and the zone's weight, 1/mm
  /// By what the robust loss bends less than a square of the same weight, in (0, 1]: its second
  /// derivative over the weight.
  std::vector<double> bend;
  PressedPlane plane;  ///< the untouched face below the ball
  std::optional<ToldDepth> told_depth;
  std::vector<double> lifted_sd_mm;  ///< what the form of the lift-off leaves open
  std::vector<const OutlinePoint*> outline;
  std::vector<double> outline_root_weight;  ///< 1 / sigma with the robust weight, 1/rad
  /// The direction in which the weighted outline moves when ball and face move apart along z, unit,
  /// and the part of it that is left: the outline tells where the ball is before the camera, and
  /// brightness where it is in the face, whose own distance is known no better than kFaceSdMm.
  Eigen::VectorXd outline_apart;
  double outline_left = 1.0;

  /// Takes that out of the outline's weighted residuals, or out of a column of their derivatives.
  void take_out_apart(Eigen::Ref<Eigen::VectorXd> values) const {
    if (outline_apart.size() == values.size())
      values -= (1.0 - outline_left) * outline_apart.dot(values) * outline_apart;
  }
};

/// Standard deviation of the face's distance as its edges tell it, of one press.
constexpr double kFaceSdMm = 0.05;

/// Standard deviation of what optics spread light by, px^2: sharp and soft lenses, clear and milky
/// layers (Smoothing::blur_px2 has their mean).
constexpr double kOpticsSdPx2 = 0.4;

/// How well lift_off.h tells what the skin is off the ball by, as a part of it: other beds than
/// Winkler's come back earlier or later.
constexpr double kLiftPart = 0.5;

/// Whether the fit moves the lift-off length.
[[nodiscard]] inline bool lift_is_free(const JointFit& fit, const JointOptions& options) {
  return options.free_lift && !options.fix_mapping && fit.lift_mm > 0.0;
}

/// The samples in the zone around a ball, robustly weighted by their residuals, and the outline.
[[nodiscard]] Weighted weigh(const PressSamples& press,
                             const JointFit& fit,
                             const Eigen::Vector3d& centre,
                             const JointOptions& options);

/// Brightness: w slope (x - g(d(c) + blur)), one residual a sample. Parameter blocks: the ball's
/// centre, the mapping's numbers, the logarithm of the lift-off length in mm, which does nothing
/// where skin and ball are taken to part at the rim. Keeps references to what it is made from.
class PressCost final : public ceres::CostFunction {
 public:
  PressCost(const Weighted& weighted,
            const MappingCurve& curve,
            const JointOptions& options,
            bool lifts_off = false);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  const Weighted& weighted_;
  const MappingCurve& curve_;
  const JointOptions& options_;
  bool lifts_off_;
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

/// Residuals of samples count as if each were by itself, and some of them share their noise: what
/// is known from elsewhere counts as much more.
constexpr double kRootWeightOfKnown = 1.7;

/// What is known beforehand of a layer's absorption over its scattering: clear silicone with white
/// pigment absorbs little (NUMERICS of the layer: 0 to 0.2). Presses that tell it overrule this;
/// the others must not take a straight line for its opposite. Parameter block: the mapping's
/// numbers.
class AbsorptionCost final : public ceres::CostFunction {
 public:
  explicit AbsorptionCost(const MappingCurve& curve);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;
  static constexpr double kMean = 0.05, kSd = 0.1;

 private:
  int numbers_;
};

/// A press depth that was measured: (R - height of the centre over the face - depth) / sd.
/// Parameter block: the ball's centre. Keeps a reference to what it is made from.
class ToldDepthCost final : public ceres::CostFunction {
 public:
  /// weighted.told_depth must be there.
  explicit ToldDepthCost(const Weighted& weighted);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  const Weighted& weighted_;
};

/// What the mapping reads a punch's step as, less what the step is, over its standard deviation.
/// Parameter block: the mapping's numbers. Keeps references.
class StepCost final : public ceres::CostFunction {
 public:
  StepCost(const StepSamples& step, const MappingCurve& curve, MappingAlong along);
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

 private:
  const StepSamples& step_;
  const MappingCurve& curve_;
  MappingAlong along_;
  double sd_mm_ = 0;  ///< of the curve that it was made with: a weight must not move with the fit
};

/// What is known beforehand of the lift-off length: kUsualLiftMm, within a factor of e. Parameter
/// block: its logarithm.
class LiftCost final : public ceres::CostFunction {
 public:
  LiftCost();
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;
};

/// The angle by which a ray passes outside the ball (negative: meets it), and its derivative by the
/// centre (may be null). NaN with the camera inside the ball.
[[nodiscard]] double outline_angle_rad(const Eigen::Vector3d& direction,
                                       const Eigen::Vector3d& centre_mm,
                                       double radius_mm,
                                       Eigen::Vector3d* by_centre = nullptr);

}  // namespace alltact
