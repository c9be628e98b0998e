// A press made with a flat punch that has a step of known height: two plateaus in the skin, whose
// distance tells the scale of depth without any ball.
#pragma once

#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press_samples.h"
#include "core/finger/mapping.h"
#include "core/result.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The skin where it lies flat on the punch: away from the step and from the punch's border.
struct StepSamples {
  std::string press;
  double step_mm = 0;           ///< its height, as it was told
  PressSamples samples;         ///< of both plateaus
  std::vector<char> is_lower;   ///< of each sample: of the plateau that is pressed in less
  Eigen::Vector3d face_normal;  ///< mean, away from the camera
};

/// Finds the two plateaus by the straight line that parts them best.
/// Errors: nothing pressed; a plateau too small; no step to be seen.
[[nodiscard]] Result<StepSamples> find_step(const Press& press, const Face& face);

/// What a mapping makes of a punch: two parallel planes through the pressed-in skin, by least
/// squares.
struct StepReading {
  double height_mm = 0;       ///< distance of the planes
  double sd_mm = 0;           ///< by noise, and by what the plateaus are not flat
  Eigen::VectorXd by_values;  ///< derivative of the height by the curve's numbers
};
/// `values`: the curve's own, or others' that stand in a solver.
[[nodiscard]] StepReading read_step(const StepSamples& step,
                                    const MappingCurve& curve,
                                    const double* values,
                                    MappingAlong along);

}  // namespace alltact
