// Uncertainty of a joint fit: its weakest direction, the effect of a wrong radius, and the most
// useful next press.
#pragma once

#include "calibration/joint/joint_fit.h"
#include "core/base/message.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The direction of the mapping's values that the presses determine least, by its effect on depths.
struct WeakestDirection {
  double depth_mm = 0;  ///< where on the curve its effect is largest
  double sd_mm = 0;     ///< standard deviation there
  /// all depths share the error's sign; false: shallow and deep ones differ in sign
  bool is_scale = true;
  Message sentence;
};
/// `covariance`: of curve.values(). Its principal component on depths over the domain.
[[nodiscard]] WeakestDirection weakest_direction(const MappingCurve& curve,
                                                 const Eigen::MatrixXd& covariance);

/// The effect of a radius that is wrong by 1 %, and whether the presses would show it.
struct RadiusSensitivity {
  double depth_part = 0;  ///< relative change of depths for a radius 1 % larger
  double smaller_mm = 0, given_mm = 0,
         larger_mm = 0;  ///< residual with 1 % less, as given, 1 % more
  bool is_seen = false;  ///< the given radius fits better than both by a tenth
  Message sentence;
};
/// Fits the presses again with a radius 1 % smaller and larger. nullopt when a fit fails or the job
/// is stopped.
[[nodiscard]] std::optional<RadiusSensitivity> vary_radius(
    const std::vector<const PressSamples*>& presses, const JointFit& fit,
    const JointOptions& options, const Job& job);

struct PressAdvice {
  bool enough = false;                               ///< another press would hardly help
  double along_mm = 0, across_mm = 0, depth_mm = 0;  ///< position and depth of the next press
  double sd_now_mm = 0, sd_then_mm = 0;  ///< of the depth, root mean square over the domain
  Message sentence;
};

/// Predicts the covariance with one more press, simulated at the position of each press made,
/// shallower, as deep and deeper. A third of the face without a press comes first, because nothing
/// shows whether the mapping holds there. face_length_mm: of the visible part. `enough` is true
/// where every third has a press and the best one would take less than a twentieth off.
[[nodiscard]] PressAdvice advise(const std::vector<const PressSamples*>& presses,
                                 const JointFit& fit, const JointOptions& options,
                                 double face_length_mm);

}  // namespace alltact
