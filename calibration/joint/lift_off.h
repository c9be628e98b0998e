// How the skin comes back from a ball's rim.
//
// A skin on its layer is a stretched membrane on an elastic bed: it follows a rigid ball up to a
// contact radius a and leaves it there without a corner; outside its depth dies away over one
// length, the lift-off length l (Winkler's bed under tension; K. L. Johnson, Contact Mechanics,
// 4.3). With r the radius of the cap that the ball cuts out of the untouched face,
//   a = sqrt(l^2 + r^2) - l,   depth = depth(a) exp(-(rho - a) / l)   for rho > a.
// Without l the skin is taken to follow the ball up to the rim of its cap, and all depths come out
// too deep where the rim is believed, by ten times what it was off by there.
#pragma once

#include "calibration/presses/press_samples.h"
#include "core/finger/mapping.h"

#include <Eigen/Core>

namespace alltact {

/// The untouched face below a ball, as a plane.
struct PressedPlane {
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  [[nodiscard]] double height_mm(const Eigen::Vector3d& centre_mm) const {
    return normal.dot(centre_mm - point_mm);
  }
};
/// At the sample nearest to the ball's centre.
[[nodiscard]] PressedPlane plane_below(const PressSamples& press, const Eigen::Vector3d& centre_mm);

/// Lift-off lengths of silicone skins are believed to lie around this, within a factor of e.
constexpr double kUsualLiftMm = 0.12;

/// Where the skin leaves the ball, mm from its axis, with r^2 given.
[[nodiscard]] double contact_radius_mm(double rim2_mm2, double lift_mm);

/// Depth of the skin, normal to the plane.
struct SkinDepth {
  double mm = 0;
  double by_ball = 1;    ///< by the ball's depth at the same place
  double by_height = 0;  ///< by the height of the ball's centre over the plane
  double by_lift = 0;    ///< by the lift-off length
};
/// `ball_mm`: how deep the ball is at a place, normal to the plane, negative outside its cap;
/// `lift_mm` 0: the skin is the ball.
[[nodiscard]] SkinDepth skin_depth(double ball_mm,
                                   double height_mm,
                                   double radius_mm,
                                   double lift_mm);

}  // namespace alltact
