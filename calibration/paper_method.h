// The source paper's calibration, as the peer to compare with.
#pragma once

#include "calibration/calibrate.h"
#include "calibration/press.h"

#include <vector>

namespace alltact {

/// The largest dark region after opening: pictures that are not smoothed and compared with a frame
/// of nearly the same pose are full of specks and of thin dark lines along the face's edges.
[[nodiscard]] BallFinderOptions paper_ball_finder();

struct PaperPress {
  const Press* press;
  BallGuess guess;
};

/// A circle through the steepest border of the dark disc; the ball's distance from the circle's
/// angular radius, sin(alpha) = R / |c| (orthographic camera: from the circle as the line where the
/// face meets the ball); d = z_LUF - z_D on lines along z; a cubic polynomial with a constant
/// through (x, d), the ball moved along its line of sight until the constant is zero. The stored
/// mapping is the cubic without constant through all presses after that search, written in the
/// basis of MappingParameters; one of lower degree where the cubic does not increase, said in a
/// remark. Errors: no press with a circle, no increasing curve.
[[nodiscard]] Result<Calibration> calibrate_as_paper(const std::vector<PaperPress>& presses,
                                                     const Camera& camera,
                                                     const Face& face,
                                                     double ball_radius_mm,
                                                     const Job& job,
                                                     Calibration calibration);

}  // namespace alltact
