// What is known of presses beside their pictures: depths that a stage or a gauge tells, and punches
// with a step. Either settles the scale of all depths; either may be wrong.
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

/// The punches among the presses; why one cannot be used goes to `left_out`.
[[nodiscard]] std::vector<StepSamples> find_steps(const std::vector<Press>& presses,
                                                  const Face& face,
                                                  std::vector<Message>* left_out);

/// How a fitted curve reads them.
[[nodiscard]] std::vector<StepFit> steps_of(const std::vector<StepSamples>& steps,
                                            const MappingCurve& curve,
                                            MappingAlong along);

/// A press of a ball, thinned twice.
struct MeasuredPress {
  std::string name;
  Eigen::Vector3d centre_mm;  ///< where to begin
  PressSamples* coarse;
  PressSamples* fine;
};
/// Solves from the pictures alone and takes away every measured depth and every step that lies
/// further from that than four standard deviations of both: a gauge that was not set to zero must
/// not stretch all depths. Gives the reasons. Nothing is taken away where the pictures alone leave
/// the depth open.
[[nodiscard]] std::vector<Message> drop_contradicting(const std::vector<MeasuredPress>& presses,
                                                      std::vector<StepSamples>& steps,
                                                      const CalibrationSettings& settings,
                                                      const Job& job);

}  // namespace alltact
