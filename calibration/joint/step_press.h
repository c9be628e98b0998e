// A press of a flat punch with a step of known height. Its two plateaus in the skin give the scale
// of depth without any ball.
#pragma once

#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press.h"
#include "core/base/result.h"
#include "core/finger/mapping.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The skin that lies flat on the punch: away from the step and from the punch's border.
struct StepSamples {
  std::string press;
  double step_mm = 0;           ///< its height, as specified
  PressSamples samples;         ///< of both plateaus
  std::vector<char> is_lower;   ///< of each sample: of the plateau that is pressed in less
  Eigen::Vector3d face_normal;  ///< mean, away from the camera
};

/// Finds the two plateaus by the straight line that separates them best. Errors: nothing pressed; a
/// plateau too small; no visible step.
[[nodiscard]] Result<StepSamples> find_step(const Press& press, const Face& face);

/// The step as a mapping measures it: two parallel planes through the pressed-in skin, by least
/// squares.
struct StepReading {
  double height_mm = 0;       ///< distance of the planes
  double sd_mm = 0;           ///< by noise, and by the unevenness of the plateaus
  Eigen::VectorXd by_values;  ///< derivative of the height by the curve's numbers
};
/// `values`: the curve's own, or those in a solver.
[[nodiscard]] StepReading read_step(const StepSamples& step, const MappingCurve& curve,
                                    const double* values, MappingAlong along);

}  // namespace alltact
