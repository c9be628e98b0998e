// A ball seen by a camera: where rays meet it, how large it looks, its exact outline.
//
// Camera frame, millimetres; every ray starts at the camera's centre or, for an orthographic
// camera, is parallel to z (see Ray).
#pragma once

#include "core/camera/camera.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Where a ray enters and leaves a ball, as multiples of the ray's direction.
struct RayHit {
  double near = 0, far = 0;
};

/// nullopt where the ray's line misses the ball. Stable up to grazing: the discriminant comes from
/// the vector from the centre to the line, as (R - f)(R + f), and no root is a difference of equal
/// numbers. radius_mm > 0; the direction may have any length but 0.
[[nodiscard]] std::optional<RayHit> meet_ball(const Ray& ray,
                                              const Eigen::Vector3d& centre_mm,
                                              double radius_mm);

/// Angle between two directions in [0, pi], to the last digits also where they nearly agree:
/// atan2(|(p - c) x c|, p . c).
[[nodiscard]] double angle_between(const Eigen::Vector3d& p, const Eigen::Vector3d& c);

/// Sine of the same angle, |(p - c) x c| / (|p| |c|): what the source paper writes as
/// sqrt(1 - (p.c / |p||c|)^2), without its loss of digits and its NaN.
[[nodiscard]] double sine_between(const Eigen::Vector3d& p, const Eigen::Vector3d& c);

/// Points of the ball where the rays of a camera graze it, `count` of them in even steps around:
/// a circle on the ball, the cone of tangents from the camera's centre (or along z). Empty when the
/// camera is inside the ball.
[[nodiscard]] std::vector<Eigen::Vector3d> ball_horizon_mm(bool perspective,
                                                           const Eigen::Vector3d& centre_mm,
                                                           double radius_mm,
                                                           int count);

/// The exact outline of the ball in the picture, for every camera model: the horizon's points
/// projected; behind a window, where rays do not meet in one point, moved until their own rays
/// touch the ball. Points that the camera cannot see are left out.
[[nodiscard]] std::vector<Eigen::Vector2d> ball_outline_px(const Camera& camera,
                                                           const Eigen::Vector3d& centre_mm,
                                                           double radius_mm,
                                                           int count);

/// The outline of a ball in normalised coordinates (x/z, y/z): an ellipse with its long axis
/// through the origin. Its centre is not the image of the ball's centre.
struct OutlineEllipse {
  Eigen::Vector2d centre;
  double long_axis = 0;   ///< half axis, along `centre` (along x where that is 0)
  double short_axis = 0;  ///< half axis
};

/// nullopt when the ball reaches the plane z = 0: then the outline is no ellipse.
[[nodiscard]] std::optional<OutlineEllipse> ball_ellipse(const Eigen::Vector3d& centre_mm,
                                                         double radius_mm);

/// The ball of known radius whose tangent cone fits directions at which its outline was seen, by
/// least squares of the angles. Directions need not be unit vectors; they come from the camera's
/// centre. nullopt: fewer than 3, or directions that lie in no cone of half-angle < 90 degrees.
[[nodiscard]] std::optional<Eigen::Vector3d> fit_ball_to_outline(
    const std::vector<Eigen::Vector3d>& directions, double radius_mm);

}  // namespace alltact
