// What presses where: connected regions of the depth map, in millimetres.
//
// KINDS OF TOUCH
// That something touches a finger is told from different things, for different ends:
//
//   name (where)                        told from, and from which threshold on; used for
//   ContactRegion (here)                depth: cells of 4 px deeper on average than 0.1 mm (setting
//                                       contact_threshold_mm) and 4 sd of untouched skin; results
//   Push (push.h)                       the markers' way from where they rest, summed: more than
//                                       the finger's ContactSettings::threshold_px, which install
//                                       of a reference sets to 5 sd (reference_recording.cpp);
//                                       whether the whole finger is pushed, from any side; results
//   FingerContact                       Push and ContactRegion together, the latter from 0.15 mm;
//   (finger_contact.h)                  lasts until both are below 0.6 of that; results
//   dented cells (depth_along_z.cpp)    depth: cells deeper than 0.02 to 0.1 mm, by the quietest
//                                       quarter of the face; where depth is looked up along z
//   untouched skin (light_gain.h)       brightness over the reference's: within 4 sd of a smooth
//                                       change; the light's change, noise
//   ReferenceFreeContact                brightness of a patch against its surroundings and the
//   (reference_free_contact.h)          frames before: 5 % darker and 6 sd; before there is a
//                                       reference
//   DentedFrame (recording_study.h)     brightness of a patch against the rest of the recording:
//                                       4 % darker and 8 sd of its zone; frames left out of a
//                                       reference
//   BallGuess (press.h)                 brightness: a disc 1.2 % darker and 5 times the scatter, to
//                                       40 % of its darkest; where a press's ball begins
//   sure zone (sample_misfit.h)         geometry: within 0.65 of the rim of the ball's cap; where
//                                       skin and ball touch on any material, for calibration
//   punched part (step_press.cpp)       brightness: 15 % of the greatest difference and 6 sd; what
//                                       lies under a punch with a step
//   FaceTouch (face_touch.h)            a ContactRegion deeper than 0.15 mm; without a mapping
//                                       0.1 % of the face darker by 12 %; without a reference a
//                                       ReferenceFreeContact; what the Studio says of the live
//                                       finger
//
// "Untouched" elsewhere is the skin as the reference shows it, whatever presses now.
#pragma once

#include "core/sensing/depth/depth_limits.h"
#include "core/sensing/depth/depth_sd.h"
#include "core/sensing/depth/local_depth.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct ContactRegion {
  Eigen::Vector3d place_mm;  ///< depth-weighted centre on the pressed face, camera frame
  Eigen::Vector2d place_px;  ///< the same in the picture
  Eigen::Vector2d place_on_face_mm = {
      0, 0};  ///< the same along the face and across it (FaceShape::place_mm)
  /// Where on the face the skin lies that is pressed deepest (FaceShape::place_mm), told from all
  /// of the region, as if what presses were alike on both sides of its middle.
  Eigen::Vector2d deepest_on_face_mm = {0, 0};
  Eigen::Vector3d deepest_point_mm;
  double deepest_mm = 0;                ///< greatest depth
  std::optional<double> deepest_sd_mm;  ///< as RegionOptions::pressed says; absent without it
  double area_mm2 = 0;                  ///< on the face
  double volume_mm3 = 0;                ///< displaced, along z
  int pixels = 0;
  /// Bits of DepthLimit. With kLayerLimit some pixels are at the layer's limit: deepest_mm,
  /// volume_mm3 and every depth there are least values. kSteep is that of single pixels and not
  /// told of a region.
  std::uint8_t limits = 0;
  /// Of place_mm: the face errs along the line of sight, the depth along z, the latter by what
  /// RegionOptions::pressed says. Not how well the lens is known. Absent without `pressed`.
  std::optional<Eigen::Matrix3d> place_covariance_mm2;
  /// How noise moves the centre over the face, along it and across; absent without `pressed`.
  std::optional<Eigen::Matrix2d> centre_covariance_mm2;
  /// Principal axis on the face from the finger's length (base to tip) towards +y, in
  /// (-90, 90]; absent when the region is round, or the sd above 15 degrees.
  std::optional<double> angle_deg;
  std::optional<double> angle_sd_deg;     ///< as contact_regions() says
  std::optional<Eigen::Vector3d> axis;    ///< the same as a unit vector, camera frame
  std::optional<Eigen::Vector3d> normal;  ///< of the untouched face there, away from the camera
  /// Convex hull of the pressed pixels, as those that are stood on are: mm along the face and
  /// across it (FaceShape::place_mm), corners in order; straight to a quarter of a pixel.
  std::vector<Eigen::Vector2d> polygon_mm;
};

struct RegionOptions {
  double threshold_mm = 0.1;  ///< depth that counts as a contact
  double noise_mm = 0.0;      ///< sd of a pixel's depth; the threshold is at least 4 of it
  double minimum_area_mm2 = 0.25;
  double correlated_px2 = 1.0;         ///< pixels that share their noise, by the smoothing
  bool is_light_doubtful = false;      ///< is_light_doubtful() of the frame
  double axis_beyond_noise_deg = 0.0;  ///< what turns the axis of a contact 1 mm wide besides noise
  /// How far off untouched skin may be told at a pixel (u, v), as DepthError::untouched; empty: by
  /// noise_mm everywhere.
  std::function<UntouchedSd(int, int)> untouched;
  /// How far off a depth in mm may be at a pixel (u, v), as DepthError::of_depth; empty: noise_mm.
  std::function<DepthCauses(int, int, double)> pressed = {};
};

/// Regions ordered by volume, largest first; but those whose greatest depth is less than half as
/// many of its standard deviations as the surest one's come last, because in a pose that was never
/// recorded a wide stretch may seem dented a little.
///
/// A cell is touched where its mean depth is above the threshold and at least 4 times what noise
/// and reference can make of untouched skin there: sd^2 = noise^2 / n + systematic^2, n its
/// independent pixels (one in correlated_px2). A region's mean depth must be that, too, with n its
/// own, and its greatest depth 4 times what that may be off by, but for DepthCauses::lateral: what
/// lies a little beside a steep wall is as deep all the same.
///
/// Where the skin is pressed deepest: skin moves along z, so that on a face inclined by theta the
/// middle of a body, that of the volume which it displaces, and the skin that lies deepest below it
/// differ by d sin(theta) along the face, d the greatest depth. The skin's own centre, weighted
/// with d - h (h the depth at which the region ends), lies between them, (sum of (d - h)^2 / sum of
/// (d - h) / 2 + h) sin(theta) from the middle, by partial integration.
///
/// The angle is that of principal_axis.h. Its sd holds what noise does and axis_beyond_noise_deg,
/// the latter over the square root of the region's width (sd across its axis, mm); not how well
/// lens, mapping and light are known.
[[nodiscard]] std::vector<ContactRegion> contact_regions(const DepthMap& depth,
                                                         const FaceShape& shape,
                                                         const Face& face,
                                                         const RegionOptions& options);

}  // namespace alltact
