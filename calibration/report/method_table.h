// Comparison of the methods on the same presses.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "core/message.h"

#include <vector>

namespace alltact {

/// Result of one method. Where `failed` is not empty other fields are unset.
struct MethodRow {
  CalibrationMethod method = CalibrationMethod::kJoint;
  int presses = 0;            ///< with a ball found
  double press_depth_mm = 0;  ///< greatest depth of the ball, mean over presses
  double residual_mm = 0;     ///< mean absolute, of its own mapping on its own balls
  double at_depth_mm = 0;     ///< depth by this method where the joint method's mapping reads...
  double joint_depth_mm = 0;  ///< ...this, which lies within both domains
  Message failed;             ///< why there is no mapping
};

/// `joint` is the solution of calibrate() for these presses; circle and cone are run on them
/// unchanged. `as_paper`: the same presses measured by the source paper's method, for its row, or
/// why that failed. Rows: joint, paper, circle, cone; fewer when the job was stopped.
[[nodiscard]] std::vector<MethodRow> compare_methods(const std::vector<Press>& presses,
                                                     const Result<std::vector<Press>>& as_paper,
                                                     const Camera& camera,
                                                     const Face& face,
                                                     const Calibration& joint,
                                                     const Job& job);

}  // namespace alltact
