// Balls from their dark border alone: the occluding contour, and the methods that use nothing else
// (paper, circle, cone). They estimate ball by ball, then fit one polynomial through all presses.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/geometry/circle_fit.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

// Occluding contour of a pressed ball: the part of the dark border that is the ball's outline.
//
// Seen from the camera's centre a ball of radius R at c fills a cone of half angle asin(R / |c|).
// Its horizon, the circle where the line of sight grazes it, shows as a border only inside the
// layer, where it is pressed deeper than the untouched face. With b the angle between sight and
// face, a ball pressed in by h (along the normal) shows 2 acos((1 - h/R) / cos b) of it. It shows
// none when 1 - h/R > cos b: a face seen steeply from above occludes nothing. Brightness jumps at
// the horizon; elsewhere the border is where the skin leaves the ball, and brightness fades.

/// A point on the horizon that lies in the layer.
struct HorizonPoint {
  Eigen::Vector3d point_mm;
  Eigen::Vector2d pixel;
  Eigen::Vector2d outward;  ///< unit, in the image, away from the ball
};

/// The part of a ball's horizon that hides untouched face, in even steps of `step_deg` around the
/// ball. Empty for an orthographic camera, whose rays are normal to the face.
[[nodiscard]] std::vector<HorizonPoint> occluding_horizon(const FaceShape& shape,
                                                          const Eigen::Vector3d& centre_mm,
                                                          double radius_mm, double step_deg);

struct TangentArc {
  std::vector<OutlinePoint> points;
  double arc_deg = 0;  ///< of the horizon around the ball; 0: none
};

/// Searches the outline in the image of a press whose ball is known to a few pixels. Along the
/// normal of each piece of the occluding horizon it fits the jump that explains the brightness
/// best, to a fraction of a pixel. The arc counts only where jumps explain the image clearly better
/// than a fading border, exceed the noise, and form at least 20 degrees.
[[nodiscard]] TangentArc find_tangent_arc(const Press& press, const Eigen::Vector3d& centre_mm,
                                          double radius_mm);

// The source paper's ball: a circle in the image. Its position and size are searched until the
// polynomial of depth over brightness has a constant of zero.

/// The dark disc of a press: the circle through the border of the largest region darker than 40 %
/// of the darkest. Thin lines and specks are removed by an opening. For a ball that a person set
/// it is the ball's outline. Errors: nothing dark enough, no circle.
[[nodiscard]] Result<Circle> dark_circle(const Press& press, const Camera& camera);

/// The ball that a circle represents. Perspective: in the direction of its middle, at R /
/// sin(alpha), alpha the angle from the middle to the circle's lowest point (the paper's p').
/// Orthographic, where size does not show distance: at `height_mm`, where the ball leaves the plane
/// with the circle's radius. nullopt: no such ball.
[[nodiscard]] std::optional<Eigen::Vector3d> ball_of_circle(const Circle& circle,
                                                            const Camera& camera,
                                                            double ball_radius_mm,
                                                            double height_mm);

/// Result of the search.
struct SearchedCircle {
  Circle circle;
  Eigen::Vector3d ball_mm = Eigen::Vector3d::Zero();
  double constant_mm = 0;  ///< of the cubic through (x, d): its remainder
  double misfit = 0;       ///< rms residual of the cubic, over the spread of d
};

/// Finds the circle for which the cubic's constant is zero. That is one equation for three
/// unknowns. At each position of the middle some size meets it; among these the best fitting cubic
/// is chosen. Middles lie within 1.2 of the ball's radius of `dark`. Sizes are those for which the
/// ball presses between nothing and the layer's thickness. `samples`: of the dark disc. Error: no
/// circle meets it, or the best cubic leaves 0.3 of the depths' spread, as noise does.
[[nodiscard]] Result<SearchedCircle> search_circle(const Press& press, const Circle& dark,
                                                   const std::vector<Sample>& samples,
                                                   const Camera& camera, const Face& face);

/// The samples of a press, blocks of 2 px, within a circle in the image.
[[nodiscard]] std::vector<Sample> samples_inside(const Press& press, const Face& face,
                                                 const Circle& circle);

/// A press with its ball.
struct FoundBall {
  const Press* press;
  BallGuess guess;
  PressSamples fine, coarse;   ///< for the solution; for the choice of the model
  double tangent_arc_deg = 0;  ///< of the outline that entered the fit
};

/// Estimates each ball from the border of its dark disc:
///   kCircle  a circle through the steepest pixels is where the skin leaves the ball, which is
///            pressed in by h = R - sqrt(R^2 - a^2), a the circle's radius on the face;
///   kCone    the arc of the border that is the ball's outline (TangentArc, at least 40 degrees;
///            less does not determine the distance) is tangent to the cone of half angle
///            asin(R / |c|).
/// The mapping is one polynomial through all depths. Errors: no press with a ball, no increasing
/// curve.
[[nodiscard]] Result<Calibration> calibrate_by_outline(const std::vector<FoundBall>& presses,
                                                       CalibrationMethod method, const Face& face,
                                                       const Job& job, Calibration calibration);

// The source paper's calibration: each press's circle searched separately, then one cubic without
// constant through all of them.

/// `presses` must be measured by the paper's own steps (PaperMethod); otherwise the results mix two
/// methods. Presses whose circle cannot be found are left out with their reason. Errors: no press
/// with a circle, no increasing curve.
[[nodiscard]] Result<Calibration> calibrate_as_paper(const std::vector<Press>& presses,
                                                     const Camera& camera, const Face& face,
                                                     const Job& job);

}  // namespace alltact
