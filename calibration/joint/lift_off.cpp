#include "calibration/joint/lift_off.h"

#include <cmath>

namespace alltact {

PressedPlane plane_below(const PressSamples& press, const Eigen::Vector3d& centre_mm) {
  const Sample* nearest = nearest_sample(press, centre_mm);
  return nearest == nullptr ? PressedPlane{} : PressedPlane{nearest->untouched_n, nearest->normal};
}

double contact_radius_mm(double rim2_mm2, double lift_mm) {
  return rim2_mm2 / (std::sqrt(lift_mm * lift_mm + rim2_mm2) + lift_mm);
}

SkinDepth skin_depth(double ball_mm, double height_mm, double radius_mm, double lift_mm) {
  const double rim2 = (radius_mm - height_mm) * (radius_mm + height_mm);
  if (!(lift_mm > 0.0) || !(rim2 > 0.0)) return {ball_mm};
  const double up = ball_mm + height_mm;  // of the ball's surface below its centre
  const double contact = contact_radius_mm(rim2, lift_mm);
  const double root = contact + lift_mm;
  const double rho2 = (radius_mm - up) * (radius_mm + up);
  if (rho2 <= contact * contact || !(radius_mm > contact)) return {ball_mm};
  const double rho = std::sqrt(rho2);
  const double up_there = std::sqrt((radius_mm - contact) * (radius_mm + contact));
  const double depth_there = up_there - height_mm;
  const double left = std::exp(-(rho - contact) / lift_mm);
  // Derivatives of a and of rho.
  const double contact_by_height = -height_mm / root, contact_by_lift = lift_mm / root - 1.0;
  const double rho_by_up = -up / rho, there_by_contact = -contact / up_there;
  SkinDepth skin;
  skin.mm = depth_there * left;
  skin.by_ball = -skin.mm * rho_by_up / lift_mm;
  skin.by_height = left * (there_by_contact * contact_by_height - 1.0) -
                   skin.mm * (rho_by_up - contact_by_height) / lift_mm;
  skin.by_lift = left * there_by_contact * contact_by_lift + skin.mm * contact_by_lift / lift_mm +
                 skin.mm * (rho - contact) / (lift_mm * lift_mm);
  return skin;
}

}  // namespace alltact
