// The peers: every ball from its dark border alone, then one polynomial through all presses.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"

#include <vector>

namespace alltact {

/// What a method looks for balls with. The paper takes the largest dark region after opening:
/// pictures that are not smoothed and compared with a frame of nearly the same pose are full of
/// specks and of thin dark lines along the face's edges.
[[nodiscard]] BallFinderOptions ball_finder_for(CalibrationMethod method);

struct OutlinePress {
  const Press* press;
  BallGuess guess;
};

/// How a ball follows from the border of the dark disc:
///   kCircle  a circle through its steepest places is where ball and face part, so that the ball
///            goes in by h = R - sqrt(R^2 - a^2), a the circle's radius on the face;
///   kCone    the part of it that is the ball's outline (tangent_arc.h, at least 40 degrees: with
///            less the distance is anyone's guess) touches the cone of half angle asin(R / |c|);
///   kPaper   the circle is taken for the outline, sin(alpha) = R / |c| (orthographic camera: as
///            kCircle), and the ball then moved along its line of sight until the constant of a
///            cubic through (x, d) is zero.
/// The stored mapping is the cubic without constant through d = z_LUF - z_D of all presses, D on
/// lines along z, written in the basis of MappingParameters; one of lower degree where the cubic
/// does not increase, said in a remark. Errors: no press with a ball, no increasing curve.
[[nodiscard]] Result<Calibration> calibrate_by_outline(const std::vector<OutlinePress>& presses,
                                                       CalibrationMethod method,
                                                       const Camera& camera,
                                                       const Face& face,
                                                       const Job& job,
                                                       Calibration calibration);

}  // namespace alltact
