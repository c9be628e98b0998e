// The source paper's ball: a circle in the picture, whose place and size are searched until the
// polynomial through depth over brightness has a constant of zero.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/presses/press_samples.h"
#include "core/camera/camera.h"
#include "core/geometry/circle_fit.h"
#include "core/result.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The dark disc of a press: the largest part darker than 40 % of the darkest, thin lines and
/// specks opened away, and the circle through its border. Of a ball that a hand put there its
/// outline. Errors: nothing dark enough, no circle.
[[nodiscard]] Result<Circle> dark_circle(const Press& press, const Camera& camera);

/// The ball that a circle stands for. Perspective: in the direction of its middle, at R /
/// sin(alpha), alpha the angle from the middle to the circle's lowest point (the paper's p').
/// Orthographic, where size tells no distance: at `height_mm`, where the ball comes out of the
/// plane by the circle's radius. nullopt: no such ball.
[[nodiscard]] std::optional<Eigen::Vector3d> ball_of_circle(const Circle& circle,
                                                            const Camera& camera,
                                                            double ball_radius_mm,
                                                            double height_mm);

/// What the search found.
struct SearchedCircle {
  Circle circle;
  Eigen::Vector3d ball_mm = Eigen::Vector3d::Zero();
  double constant_mm = 0;  ///< of the cubic through (x, d): what is left of it
  double misfit = 0;       ///< rms of what the cubic leaves, over the spread of d
};

/// The circle for which the cubic's constant is zero. That is one equation for three unknowns: at
/// each place of the middle some size meets it, and of these the one whose cubic fits best is
/// taken. Middles within 1.2 of the ball's radius of `dark`; sizes for which the ball presses
/// between nothing and the layer's thickness. `samples`: of the dark disc. Error: no circle meets
/// it, or only such whose cubic leaves 0.3 of the depths' spread, as noise does.
[[nodiscard]] Result<SearchedCircle> search_circle(const Press& press,
                                                   const Circle& dark,
                                                   const std::vector<Sample>& samples,
                                                   const Camera& camera,
                                                   const Face& face);

}  // namespace alltact
