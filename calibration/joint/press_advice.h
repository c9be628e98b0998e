// What the presses leave uncertain, in words, and which press would help most.
#pragma once

#include "calibration/joint/joint_fit.h"
#include "core/message.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The direction of the mapping's numbers that the presses tell least, as what it does to depths.
struct Weakness {
  double depth_mm = 0;   ///< where on the curve it shows most
  double sd_mm = 0;      ///< how much, there
  bool is_scale = true;  ///< all depths go wrong alike; false: shallow and deep ones differently
  Message sentence;
};
/// covariance: of curve.values(). Its principal component on depths over the whole domain.
[[nodiscard]] Weakness weakest_direction(const MappingCurve& curve,
                                         const Eigen::MatrixXd& covariance);

/// What a radius that is wrong by 1 % does, and whether the presses would show it.
struct RadiusSense {
  double depth_part = 0;  ///< change of depths, as a part of them, for a radius 1 % larger
  double smaller_mm = 0, given_mm = 0,
         larger_mm = 0;  ///< residual with 1 % less, as given, 1 % more
  bool is_seen = false;  ///< the radius given fits better than both by a tenth
  Message sentence;
};
/// Fits the presses again with a radius 1 % smaller and larger. nullopt when a fit fails or the job
/// is stopped.
[[nodiscard]] std::optional<RadiusSense> sense_radius(
    const std::vector<const PressSamples*>& presses,
    const JointFit& fit,
    const JointOptions& options,
    const Job& job);

struct PressAdvice {
  bool enough = false;                               ///< another press would hardly help
  double along_mm = 0, across_mm = 0, depth_mm = 0;  ///< where and how deep to press next
  double sd_now_mm = 0, sd_then_mm = 0;  ///< of the depth, root mean square over the domain
  Message sentence;
};

/// Tries, in the mind, one press more at the place of each that was made and in thirds of the face
/// that have none, shallower, as deep and deeper, and reckons what the covariance would be then. A
/// third of the face without a press comes first: nothing tells whether the mapping holds there.
/// face_length_mm: of the part that is seen. Enough is said where every third has a press and the
/// best one would take less than a twentieth off.
[[nodiscard]] PressAdvice advise(const std::vector<const PressSamples*>& presses,
                                 const JointFit& fit,
                                 const JointOptions& options,
                                 double face_length_mm);

}  // namespace alltact
