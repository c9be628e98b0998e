// Every method on the same presses, side by side.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "core/message.h"

#include <vector>

namespace alltact {

/// What one method made of the presses. Where `failed` is not empty nothing else is known.
struct MethodRow {
  CalibrationMethod method = CalibrationMethod::kJoint;
  int presses = 0;            ///< that it found a ball in
  double press_depth_mm = 0;  ///< mean over these of the greatest depth of the ball
  double residual_mm = 0;     ///< mean absolute, of its own mapping on its own balls
  double at_depth_mm = 0;     ///< what it reads where the joint method's mapping reads...
  double joint_depth_mm = 0;  ///< ...this, which lies within both domains
  Message failed;             ///< why there is no mapping
};

/// `joint` is the solution of calibrate() for these presses; a circle and a cone are run on them as
/// they are. `as_paper`: the same presses as the source paper's method measures them, which its row
/// is of, or why it cannot. Rows: joint, paper, circle, cone. Shorter when the job was
/// stopped.
[[nodiscard]] std::vector<MethodRow> compare_methods(const std::vector<Press>& presses,
                                                     const Result<std::vector<Press>>& as_paper,
                                                     const Camera& camera,
                                                     const Face& face,
                                                     const Calibration& joint,
                                                     const Job& job);

}  // namespace alltact
