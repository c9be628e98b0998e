// The principal axis of a contact, weighed by how sure its depths are.
//
// It is the greater eigenvector of the second moments of the displaced volume below the threshold,
// column by column along z, seen upright on the face at the contact's place, where a rigid body's
// axis is straight. A column weighs
//   w = g area (depth - threshold),   g = 1 / variance
// so that the brighter, surer part of a long contact counts for more. The variance is that of the
// skin at that place before it is pressed: one that fell with depth would weigh depth twice. And
// log g is taken to be linear over the contact: such weights shift the middle of a Gaussian and
// leave its axis, while others, a dark spot's for instance, turn it. What has an end they turn as
// well, by the square of their slope; so they change by no more than a factor of 2 from end to end
// (a paraboloid of 4 x 1.8 mm is turned by 0.2 degrees at a factor of 4, more than noise does).
//
// An error e of a depth adds volume at the pressed point (x, y), along and across the axis; to
// first order that turns it by g area x y e / (sum of w (l1 - l2)).
#pragma once

#include "core/sensing/contact/contact_frame.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// What some neighbouring pixels displace. Places in mm, camera frame, from one origin.
struct ContactColumn {
  Eigen::Vector3d middle_mm;   ///< of the volume between the threshold and the depth
  Eigen::Vector3d pressed_mm;  ///< the pressed point
  double volume_mm3 = 0;       ///< above the threshold
  double height_mm = 0;        ///< the same by the area
  double skin_sd_mm = 0;       ///< of a depth there before it is pressed; 0: not known
  double noise_mm6 = 0;        ///< variance of the volume, were pixels independent
};

struct PrincipalAxis {
  double angle_rad = 0;  ///< in (-pi/2, pi/2], in the plane from its first axis to its second
  double sd_rad = 0;     ///< by the noise, with all that pixels share
  double greater_mm2 = 0, smaller_mm2 = 0;  ///< variances along and across
};

/// correlated_px2: pixels that share their noise. nullopt: exactly round, or no volume.
[[nodiscard]] std::optional<PrincipalAxis> principal_axis(const std::vector<ContactColumn>& columns,
                                                          const ContactPlane& plane,
                                                          double correlated_px2);

}  // namespace alltact
