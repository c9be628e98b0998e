// Estimates how far from its base the finger is pushed on its back, from the markers alone.
//
// BACKGROUND
// On the contact face the indentation shows the position of a contact. On the back only the
// markers' motion does: the nearer to the base the push, the more of the bend lies near the base. A
// beam that is clamped there moves in BeamModes by q = K^-1 f, with the stiffness EI(t)
//   K = integral of EI w_i'' w_j'',  f = (t^2, t^3 - t^2) of a push at t,
// so that q2 / q1 determines t: about -1.3 at a quarter of the length, -0.8 in the middle, -0.2 at
// the tip. How EI falls towards the tip was not measured. Two walls that ribs join have
//   EI = 1 - falls + falls D^2,  D the walls' distance, which falls to about a quarter,
// with falls from two thirds (ribs that carry a hundredth of the shear) to nearly 1 (all of it).
// Several values are taken as equally likely. Near 0.6 of the length all agree; a third of the
// length from there they differ by a tenth of it. A drag along the finger of up to 0.15 of the
// force is marginalised likewise. The likelihood of each position is that of the markers' motion,
// over all of these parameters. The results are the mean and the standard deviation. They hold for
// such a body, not for one that is cut out, clamped elsewhere, or leans on something else too.
//
// NOT THE SIDES
// A push on a side has no observable position along it. Three methods were tried:
// - Walls bend evenly in their own plane. Their q2 / q1 goes from -0.8 at a quarter of the length
//   to -0.5 at the tip. Half a millimetre of model error changes it by as much, and the depth of
//   the push behind the face by half of that.
// - Twist over sway is the push's distance behind the face divided by its position along, of which
//   the first is equally unknown.
// - Soft material yields locally around the contact (Boussinesq: 0.02 mm at 8 mm from 1 N on rubber
//   of Shore 40 A), which would determine the position to 10 mm. The residual of sway and twist
//   after beam and shape is larger: on simulated fingers the position was 45 mm off, at 0.2 to 1 N.
#pragma once

#include "core/sensing/contact/tip_displacement.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Position along the face from the origin of its length (FaceShape::length_at).
struct AlongFinger {
  double mm = 0, sd_mm = 0;
};

/// A position with a greater sd than this share of the finger's length is not reported. Equally
/// likely positions over all of the length have 0.26 of it.
inline constexpr double kMaxAlongSd = 0.13;

/// For a push on the back. `displacement`: tip_displacement() of the same markers, `rest`, shape
/// and covariance. nullopt: the push is too small to determine its position, or bends the finger
/// beyond the range of modes and shape.
[[nodiscard]] std::optional<AlongFinger> push_along_back(
    const Markers& markers,
    const std::vector<Eigen::Vector2d>& rest,
    const FaceShape& shape,
    const Eigen::MatrixXd& displacement_cov_px2,
    const TipDisplacement& displacement);

}  // namespace alltact
