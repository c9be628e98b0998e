// Measurements of presses besides their images: depths by a stage or a gauge, and punches with a
// step. Either fixes the scale of all depths; either may be wrong.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/joint/model_choice.h"
#include "calibration/joint/step_press.h"
#include "core/job.h"
#include "core/message.h"

#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Finds the punches among the presses. `left_out` receives the reasons of unusable ones.
[[nodiscard]] std::vector<StepSamples> find_steps(const std::vector<Press>& presses,
                                                  const Face& face,
                                                  std::vector<Message>* left_out);

/// The steps as a fitted curve measures them.
[[nodiscard]] std::vector<StepFit> steps_of(const std::vector<StepSamples>& steps,
                                            const MappingCurve& curve,
                                            MappingAlong along);

/// A press of a ball, thinned twice.
struct MeasuredPress {
  std::string name;
  Eigen::Vector3d centre_mm;  ///< start of the fit
  PressSamples* coarse;
  PressSamples* fine;
};
/// Solves from the images alone and drops measured depths and steps that contradict the solution.
/// The limit is four standard deviations of both: a gauge that was not set to zero must not stretch
/// all depths. Returns the reasons. Drops nothing where the images alone leave the depth open.
[[nodiscard]] std::vector<Message> drop_contradicting(const std::vector<MeasuredPress>& presses,
                                                      std::vector<StepSamples>& steps,
                                                      const CalibrationSettings& settings,
                                                      const Job& job);

}  // namespace alltact
