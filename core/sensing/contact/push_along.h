// How far from its base the finger is pushed on its back, from the markers alone.
//
// BACKGROUND
// On the contact face a dent tells where something presses. On the back the markers' motion has to:
// the nearer to the base the finger is pushed, the more of the bend lies near the base. A beam that
// is held there moves in BeamModes by q = K^-1 f, with the stiffness EI(t)
//   K = integral of EI w_i'' w_j'',  f = (t^2, t^3 - t^2) of a push at t,
// so that q2 / q1 tells t: about -1.3 at a quarter of the length, -0.8 in the middle, -0.2 at the
// tip. How EI falls towards the tip nobody measured. Of two walls that ribs join it is
//   EI = 1 - falls + falls D^2,  D the walls' distance, which falls to about a quarter,
// with falls from two thirds (ribs that carry a hundredth of the shear) to nearly 1 (all of it): so
// many of these are taken as equally likely. Near 0.6 of the length all agree; a third of the
// length from there they differ by a tenth of it. A drag along the finger of up to 0.15 of the
// force counts in the same way. Each place is as likely as what the markers did is with it, over
// all of that; mean and standard deviation are told, which are those of such a body and not of
// one that is cut out, held elsewhere, or leans on something else too.
//
// NOT THE SIDES
// A push on a side tells no place along it, in three ways that were tried:
// - Walls bend evenly in their own plane. Their q2 / q1 goes from -0.8 at a quarter of the way to
//   -0.5 at the tip, as far as what half a millimetre of model error changes it, and where behind
//   the face the push is changes it by half of that.
// - Twist by sway would be the push's distance behind the face by its place along, of which the
//   first is as little known.
// - Soft material gives way around what pushes (Boussinesq: 0.02 mm at 8 mm from 1 N on rubber of
//   Shore 40 A), which would tell it to 10 mm; but what beam and shape leave of sway and twist is
//   more than that: on fingers drawn at random the place was 45 mm off, of 0.2 to 1 N.
#pragma once

#include "core/sensing/contact/tip_way.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Along the face from where its length counts (FaceShape::length_at).
struct AlongFinger {
  double mm = 0, sd_mm = 0;
};

/// A place of which no more is known than this share of the finger's length (sd) is not told: all
/// places that are equally likely have 0.26 of it.
inline constexpr double kMostAlongSd = 0.13;

/// Of a push on the back. `way`: tip_way() of the same markers, `rest`, shape and `ways_px2`.
/// nullopt: the push is too slight to tell its place, or bends the finger beyond what modes and
/// shape hold for.
[[nodiscard]] std::optional<AlongFinger> push_along_back(const Markers& markers,
                                                         const std::vector<Eigen::Vector2d>& rest,
                                                         const FaceShape& shape,
                                                         const Eigen::MatrixXd& ways_px2,
                                                         const TipWay& way);

}  // namespace alltact
