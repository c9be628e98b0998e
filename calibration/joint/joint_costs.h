// The residuals of the joint fit with their derivatives, for the solver and for tests that compare
// the derivatives with differences.
#pragma once

#include "calibration/joint/joint_fit.h"
#include "calibration/joint/known_shape.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press.h"

#include <optional>
#include <vector>

#include <ceres/cost_function.h>
#include <ceres/sized_cost_function.h>

namespace alltact {

/// The samples of one press in the zone, and its outline, with their weights for one round.
struct WeightedPress {
  double ball_radius_mm = 0;
  std::vector<const Sample*> samples;
  std::vector<double> blur_mm;      ///< see blur_mm(), of the previous round
  std::vector<double> slope_mm;     ///< dM/dx at the ball's depth, of the previous round
  std::vector<double> root_weight;  ///< 1 / sigma with the weights of loss and zone, 1/mm
  /// Second derivative of the robust loss over its weight, in (0, 1].
  std::vector<double> bend;
  PressedPlane plane;  ///< the untouched face below the ball
  std::optional<GivenDepth> given_depth;
  std::vector<double> lifted_sd_mm;  ///< sd by the unknown form of the lift-off
  std::vector<const OutlinePoint*> outline;
  std::vector<double> outline_root_weight;  ///< 1 / sigma with the robust weight, 1/rad
  /// The unit direction in which the weighted outline moves when ball and face move apart along z,
  /// and the fraction of it that is retained. The outline shows the ball's distance from the
  /// camera, brightness its depth in the face. The face's own distance is known to kFaceSdMm only.
  Eigen::VectorXd outline_along_z;
  double outline_z_gain = 1.0;

  /// Damps that direction in the outline's weighted residuals, or in a column of their derivatives.
  void damp_along_z(Eigen::Ref<Eigen::VectorXd> values) const {
    if (outline_along_z.size() == values.size())
      values -= (1.0 - outline_z_gain) * outline_along_z.dot(values) * outline_along_z;
  }
};

/// Standard deviation of the face's distance, estimated from its edges, of one press.
constexpr double kFaceSdMm = 0.05;

/// Standard deviation of the blur of optics, px^2: sharp and soft lenses, clear and milky layers.
/// Smoothing::blur_px2 has their mean.
constexpr double kOpticsSdPx2 = 0.4;

/// Standard deviation of the distance between skin and ball by contact_model.h, as a fraction of
/// it. Beds other than Winkler's return earlier or later.
constexpr double kLiftPart = 0.5;

/// Whether the lift-off length is a free parameter of the fit.
[[nodiscard]] inline bool lift_is_free(const JointFit& fit, const JointOptions& options) {
  return options.free_lift && !options.fix_mapping && fit.lift_mm > 0.0;
}

/// Computes robust weights of the samples in the zone around a ball, and of the outline.
[[nodiscard]] WeightedPress weight_samples(const PressSamples& press, const JointFit& fit,
                                           const Eigen::Vector3d& centre,
                                           const JointOptions& options);

/// Brightness: w slope (x - g(d(c) + blur)), one residual a sample. Parameter blocks: the ball's
/// centre; the mapping's numbers; the logarithm of the lift-off length in mm, without effect where
/// the skin leaves the ball at the rim. The arguments must outlive the cost.
class PressCost final : public ceres::CostFunction {
 public:
  PressCost(const WeightedPress& weighted, const MappingCurve& curve, const JointOptions& options,
            bool lifts_off = false);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const WeightedPress& weighted_;
  const MappingCurve& curve_;
  const JointOptions& options_;
  bool lifts_off_;
};

/// The outline: w (angle between ray and ball centre - asin(R / |c|)), one residual a point.
/// Parameter block: the ball's centre. The argument must outlive the cost.
class OutlineCost final : public ceres::CostFunction {
 public:
  explicit OutlineCost(const WeightedPress& weighted);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const WeightedPress& weighted_;
};

/// Weight of prior knowledge. The residuals of samples count as independent although some share
/// their noise, so priors count as much more.
constexpr double kRootWeightOfKnown = 1.7;

/// Prior of a layer's absorption over its scattering: clear silicone with white pigment absorbs
/// little (NUMERICS of the layer: 0 to 0.2). Presses that determine it overrule the prior. The
/// others must not fit a straight line by negative absorption.
constexpr double kAbsorptionMean = 0.05, kAbsorptionSd = 0.1;

/// Prior of one number of a parameter block: the absorption (of the mapping's numbers), or the
/// logarithm of the lift-off length (kTypicalLiftMm, within a factor of e).
class PriorCost final : public ceres::CostFunction {
 public:
  PriorCost(int numbers, int index, double mean, double sd);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  int index_;
  double mean_, sd_;
};

/// A measured press depth: (R - height of the centre over the face - depth) / sd. Parameter block:
/// the ball's centre. The argument must outlive the cost.
class GivenDepthCost final : public ceres::SizedCostFunction<1, 3> {
 public:
  /// `weighted.given_depth` must have a value.
  explicit GivenDepthCost(const WeightedPress& weighted) : weighted_(weighted) {}
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  const WeightedPress& weighted_;
};

/// The scale of depth that the mapping has by a known shape, less 1, over the standard deviation;
/// linear about the curve at construction, because the fit repeats itself with new costs until
/// nothing changes. Parameter block: the mapping's numbers.
class ScaleCost final : public ceres::CostFunction {
 public:
  ScaleCost(const KnownShape& shape, const MappingCurve& curve, MappingAlong along);
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override;

 private:
  ScaleReading reading_;
  Eigen::VectorXd values_;  ///< of the curve at construction
};

/// The angle by which a ray passes outside the ball (negative: meets it), and its derivative by the
/// centre (may be null). NaN with the camera inside the ball.
[[nodiscard]] double outline_angle_rad(const Eigen::Vector3d& direction,
                                       const Eigen::Vector3d& centre_mm, double radius_mm,
                                       Eigen::Vector3d* by_centre = nullptr);

}  // namespace alltact
