// Projection of a ball into a camera: ray intersection, apparent size and exact outline.
//
// Camera frame, millimetres; every ray starts at the camera's centre or, for an orthographic
// camera, is parallel to z (see Ray).
#pragma once

#include "core/camera/camera.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Where a ray enters and leaves a ball, as multiples of the ray's direction.
struct RayHit {
  double near = 0, far = 0;
};

/// nullopt where the ray's line misses the ball. Stable up to grazing: the discriminant is (R -
/// f)(R + f), f the distance from the centre to the line. No root is a difference of equal numbers.
/// radius_mm > 0; the direction may have any length but 0.
[[nodiscard]] std::optional<RayHit> intersect_ball(const Ray& ray, const Eigen::Vector3d& centre_mm,
                                                   double radius_mm);

/// Angle between two directions in [0, pi], accurate also for nearly equal directions: atan2(|(p -
/// c) x c|, p . c).
[[nodiscard]] double angle_between(const Eigen::Vector3d& p, const Eigen::Vector3d& c);

/// Sine of the same angle, |(p - c) x c| / (|p| |c|). The source paper writes sqrt(1 - (p.c /
/// |p||c|)^2), which loses digits and may give NaN.
[[nodiscard]] double sine_between(const Eigen::Vector3d& p, const Eigen::Vector3d& c);

/// Points of the ball where the rays of a camera graze it, `count` of them in even steps. They form
/// a circle on the ball, the cone of tangents from the camera's centre (or along z). Empty when the
/// camera is inside the ball.
[[nodiscard]] std::vector<Eigen::Vector3d> ball_horizon_mm(bool perspective,
                                                           const Eigen::Vector3d& centre_mm,
                                                           double radius_mm, int count);

/// The exact outline of the ball in the image, for every camera model: the horizon's points
/// projected. Behind a window, where rays do not start in one point, they are moved until their own
/// rays are tangent to the ball. Points outside the camera's view are left out.
[[nodiscard]] std::vector<Eigen::Vector2d> ball_outline_px(const Camera& camera,
                                                           const Eigen::Vector3d& centre_mm,
                                                           double radius_mm, int count);

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

/// Fits a ball of known radius to outline directions: its tangent cone, by least squares of the
/// angles. Directions start at the camera's centre and need not be unit vectors. nullopt: fewer
/// than 3, or directions that lie in no cone of half-angle < 90 degrees.
[[nodiscard]] std::optional<Eigen::Vector3d> fit_ball_to_outline(
    const std::vector<Eigen::Vector3d>& directions, double radius_mm);

// Indentation depth of a ball, estimated from its dark disc before any mapping is known.

/// Fraction of the depth: the level at which the border of the dark disc is drawn.
inline constexpr double kDiscLevel = 0.4;

/// A cap of height h has depth kDiscLevel h at the radius r with r^2 = 2 R h (1 - kDiscLevel), R
/// the ball's radius and h small against it. At most 0.9 R. Both radii > 0, mm.
[[nodiscard]] inline double disc_depth_mm(double disc_radius_mm, double ball_radius_mm) {
  return std::min(0.9 * ball_radius_mm,
                  disc_radius_mm * disc_radius_mm / (2.0 * (1.0 - kDiscLevel) * ball_radius_mm));
}

}  // namespace alltact
