// Circles through noisy points, also on short arcs.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct Circle {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius = 0;
  double rms = 0;  ///< root mean square distance of the points from it
};

/// Taubin's algebraic fit, by the singular values of the centred and scaled moments. It is hardly
/// biased on arcs down to 60 degrees, where the plain linear fit (Kasa) shrinks the circle.
/// nullopt: fewer than 3 points, collinear or coincident points, values not finite.
[[nodiscard]] std::optional<Circle> fit_circle_taubin(const std::vector<Eigen::Vector2d>& points);

/// The circle of minimum squared distance to the points: starts with Taubin's, then damped
/// Gauss-Newton in curvature, direction and offset of the arc. These remain finite as the arc
/// straightens. Three points are met exactly. nullopt as above, and where the best curve is
/// straight (radius above 10^6 times the extent of the points).
[[nodiscard]] std::optional<Circle> fit_circle(const std::vector<Eigen::Vector2d>& points);

}  // namespace alltact
