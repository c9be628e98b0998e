// The principal axis of a contact, weighted by the certainty of its depths.
//
// It is the greater eigenvector of the second moments of the displaced volume below the threshold,
// column by column along z. Columns are projected on the face at the contact's position, where a
// rigid body's axis is straight. A column weighs
//   w = g area (depth - threshold),   g = 1 / variance
// so that the brighter, more certain part of a long contact has more weight. The variance is that
// of the skin at that position before contact: one that fell with depth would weigh depth twice.
// log g is modelled as linear over the contact: such weights shift the middle of a Gaussian and
// leave its axis, while others, such as a dark spot's, rotate it. They also rotate a bounded body,
// by the square of their slope. Weights therefore change by no more than a factor of 2 from end to
// end. A paraboloid of 4 x 1.8 mm is rotated by 0.2 degrees at a factor of 4, more than by noise.
//
// An error e of a depth adds volume at the pressed point (x, y), along and across the axis. To
// first order it rotates the axis by g area x y e / (sum of w (l1 - l2)).
#pragma once

#include "core/sensing/contact/contact_geometry.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Volume that some adjacent pixels displace. Positions in mm, camera frame, from one origin.
struct ContactColumn {
  Eigen::Vector3d middle_mm;   ///< of the volume between the threshold and the depth
  Eigen::Vector3d pressed_mm;  ///< the pressed point
  double volume_mm3 = 0;       ///< above the threshold
  double height_mm = 0;        ///< the same by the area
  double skin_sd_mm = 0;       ///< of a depth there before contact; 0: unknown
  double noise_mm6 = 0;        ///< variance of the volume, for independent pixels
};

struct PrincipalAxis {
  double angle_rad = 0;  ///< in (-pi/2, pi/2], in the plane from its first axis to its second
  double sd_rad = 0;     ///< from noise, including its correlation
  double greater_mm2 = 0, smaller_mm2 = 0;  ///< variances along and across
};

/// correlated_px2: area of pixels with common noise. nullopt: exactly round, or no volume.
[[nodiscard]] std::optional<PrincipalAxis> principal_axis(const std::vector<ContactColumn>& columns,
                                                          const ContactPlane& plane,
                                                          double correlated_px2);

}  // namespace alltact
