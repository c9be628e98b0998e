// Start of the joint fit: the balls as found, and the mapping that follows from them.
#pragma once

#include "calibration/joint/joint_fit.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Presses and their start: the balls as found, one a press, and the punches.
struct ChoiceInput {
  std::vector<const PressSamples*> presses;
  std::vector<Eigen::Vector3d> centres_mm;
  const std::vector<StepSamples>* steps = nullptr;  ///< see JointOptions
  int max_rounds = 60;                              ///< likewise
};

inline constexpr CurveFamily kMoebiusFamily{MappingKind::kMoebius, 2};
inline constexpr CurveFamily kLayerFamily{MappingKind::kMoebius, 3};

/// The end of the domain: the largest difference in the inner zones of the contacts and on the
/// punches' levels. 0: nothing is darker than the reference.
[[nodiscard]] double domain_of(const ChoiceInput& input, MappingAlong along);

/// A straight line through the balls as found, over the domain up to `x_max`.
[[nodiscard]] JointFit straight_start(const ChoiceInput& input, MappingAlong along, double x_max);

/// The same curve in another family where that contains it, else the straight line to its end.
/// Balls and lift-off length stay.
[[nodiscard]] JointFit as_family(const JointFit& fit, CurveFamily family);

}  // namespace alltact
