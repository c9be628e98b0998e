// The source paper's ball: a circle in the image. Its position and size are searched until the
// polynomial of depth over brightness has a constant of zero.
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
[[nodiscard]] Result<SearchedCircle> search_circle(const Press& press,
                                                   const Circle& dark,
                                                   const std::vector<Sample>& samples,
                                                   const Camera& camera,
                                                   const Face& face);

}  // namespace alltact
