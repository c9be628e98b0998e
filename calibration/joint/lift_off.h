// Lift-off of the skin at the rim of a ball's contact.
//
// A skin on its layer is a stretched membrane on an elastic bed. It follows a rigid ball up to a
// contact radius a and leaves it there without a corner. Outside, its depth decays over one length,
// the lift-off length l (Winkler's bed under tension; K. L. Johnson, Contact Mechanics, 4.3). With
// r the radius of the cap that the ball cuts out of the untouched face,
//   a = sqrt(l^2 + r^2) - l,   depth = depth(a) exp(-(rho - a) / l)   for rho > a.
// Without l the skin follows the ball up to the rim of its cap. Where the fit reads the rim, all
// depths then come out too deep, by ten times the error there.
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

/// Prior of the lift-off length of silicone skins, within a factor of e.
constexpr double kTypicalLiftMm = 0.12;

/// Distance from the ball's axis at which the skin leaves the ball, mm, for a given r^2.
[[nodiscard]] double contact_radius_mm(double rim2_mm2, double lift_mm);

/// Depth of the skin, normal to the plane.
struct SkinDepth {
  double mm = 0;
  double by_ball = 1;    ///< by the ball's depth at the same position
  double by_height = 0;  ///< by the height of the ball's centre over the plane
  double by_lift = 0;    ///< by the lift-off length
};
/// `ball_mm`: depth of the ball at the position, normal to the plane, negative outside its cap.
/// `lift_mm` 0: the skin follows the ball everywhere.
[[nodiscard]] SkinDepth skin_depth(double ball_mm,
                                   double height_mm,
                                   double radius_mm,
                                   double lift_mm);

}  // namespace alltact
