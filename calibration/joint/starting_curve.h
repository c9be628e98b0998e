// Where the joint fit starts from: the balls as found, and the mapping that follows from them.
#pragma once

#include "calibration/joint/joint_fit.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Presses and where to start: the balls as found, one a press, and punches beside them.
struct ChoiceInput {
  std::vector<const PressSamples*> presses;
  std::vector<Eigen::Vector3d> centres_mm;
  const std::vector<StepSamples>* steps = nullptr;  ///< see JointOptions
  int most_rounds = 60;                             ///< likewise
};

inline constexpr CurveFamily kMoebiusFamily{MappingKind::kMoebius, 2};
inline constexpr CurveFamily kLayerFamily{MappingKind::kMoebius, 3};

/// The largest difference at which the contacts' inner parts and the punches' levels are seen: the
/// end of the domain. 0: nothing is seen darker than the reference.
[[nodiscard]] double domain_of(const ChoiceInput& input, MappingAlong along);

/// A straight line through the balls as found, over the domain up to `x_max`.
[[nodiscard]] JointFit straight_start(const ChoiceInput& input, MappingAlong along, double x_max);

/// The same curve in another family where that holds it, else the straight line to its end; balls
/// and lift-off length as they are.
[[nodiscard]] JointFit as_family(const JointFit& fit, CurveFamily family);

}  // namespace alltact
