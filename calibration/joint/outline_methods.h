// Two peers of the joint method: every ball from its dark border alone, then one polynomial through
// all presses. (The source paper's own is in paper_calibration.h.)
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"

#include <vector>

namespace alltact {

struct OutlinePress {
  const Press* press;
  BallGuess guess;
};

/// How a ball follows from the border of the dark disc:
///   kCircle  a circle through its steepest places is where ball and face part, so that the ball
///            goes in by h = R - sqrt(R^2 - a^2), a the circle's radius on the face;
///   kCone    the part of it that is the ball's outline (tangent_arc.h, at least 40 degrees: with
///            less the distance is anyone's guess) touches the cone of half angle asin(R / |c|).
/// The stored mapping is that of calibrate_through(). Errors: no press with a ball, no increasing
/// curve.
[[nodiscard]] Result<Calibration> calibrate_by_outline(const std::vector<OutlinePress>& presses,
                                                       CalibrationMethod method,
                                                       const Face& face,
                                                       const Job& job,
                                                       Calibration calibration);

}  // namespace alltact
