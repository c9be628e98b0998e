// Two alternatives to the joint method: every ball from its dark border alone, then one polynomial
// through all presses. (The source paper's own is in paper_calibration.h.)
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"

#include <vector>

namespace alltact {

struct OutlinePress {
  const Press* press;
  BallGuess guess;
};

/// Estimates each ball from the border of its dark disc:
///   kCircle  a circle through the steepest pixels is where the skin leaves the ball, which is
///            pressed in by h = R - sqrt(R^2 - a^2), a the circle's radius on the face;
///   kCone    the arc of the border that is the ball's outline (tangent_arc.h, at least 40 degrees;
///            less does not determine the distance) is tangent to the cone of half angle
///            asin(R / |c|).
/// The stored mapping is that of fit_cubic_mapping(). Errors: no press with a ball, no increasing
/// curve.
[[nodiscard]] Result<Calibration> calibrate_by_outline(const std::vector<OutlinePress>& presses,
                                                       CalibrationMethod method,
                                                       const Face& face,
                                                       const Job& job,
                                                       Calibration calibration);

}  // namespace alltact
