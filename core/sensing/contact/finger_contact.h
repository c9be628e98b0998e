// Contact of the finger: which face, in which direction it is pushed, and at which position.
#pragma once

#include "core/message.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/contact/push_along.h"
#include "core/sensing/contact/tip_displacement.h"
#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Position on the finger, mm. On the contact face it is that of the skin which is pressed deepest
/// (ContactRegion::deepest_on_face_mm). On the back it is estimated from the markers' motion
/// (push_along.h), which determines neither across nor depth. Standard deviations include the
/// image's noise and the uncertainty of the face's end at the base, of the face's distance and of
/// the depth. They exclude that of the lens.
struct PositionOnFinger {
  double along_mm = 0;              ///< along the face from its base (FaceShape::length_at)
  std::optional<double> across_mm;  ///< from its middle line towards +y
  std::optional<double> depth_mm;   ///< the greatest, along z
  /// Empty where the region has no covariance. along_sd_mm is also empty where the base's end is
  /// not seen, so that along_mm counts from the first column that shows the face.
  std::optional<double> along_sd_mm, across_sd_mm, depth_sd_mm;
  std::uint8_t limits = 0;  ///< bits of DepthLimit: with kLayerLimit depth_mm is a lower bound
};

struct FingerContact {
  /// The contact face where something is pressed into it; else the face opposite to the deflection.
  PushedFace face = PushedFace::kContact;
  /// Unit vector, camera frame: the direction of the deflection (tip_displacement.h). Without a
  /// deflection, the normal into the contact face at the position. Empty: neither is known.
  std::optional<Eigen::Vector3d> direction;
  /// Within the finger's section; empty where the direction is the face's normal.
  std::optional<double> direction_sd_deg;
  std::optional<PositionOnFinger> position;
  Message no_position;           ///< reason why there is no position; empty when there is one
  bool is_new = false;           ///< it began in this frame
  std::optional<double> held_s;  ///< since it began; empty where frames have no time
  /// The object moves over the skin (contact_state.h); empty where this is unknown.
  std::optional<bool> is_slipping;
};

/// Evidence of a contact in one frame.
struct ContactEvidence {
  const Push* push = nullptr;  ///< null: no marker shows one
  double push_threshold_px = 0;
  std::optional<TipDisplacement> displacement;
  std::optional<AlongFinger> along_back;                ///< of a push on the back
  const std::vector<ContactRegion>* regions = nullptr;  ///< null: there is no depth
  /// The larger of push_strength() and depth_strength(). 1 is the threshold: that of a push
  /// (push.h), or the depth of face_contact.h.
  [[nodiscard]] double strength() const;
  [[nodiscard]] double push_strength() const;
  [[nodiscard]] double depth_strength() const;
};

/// Covariance of a region's position on the face, along it and across it. nullopt: the region has
/// none.
[[nodiscard]] std::optional<Eigen::Matrix2d> position_covariance_on_face_mm2(
    const ContactRegion& region, const FaceShape& shape);

/// The face from which the finger was deflected.
[[nodiscard]] PushedFace face_of_motion(const TipDisplacement& displacement);

/// Result for a frame with a contact. `before`: the face of the same contact in the frame before,
/// used where this frame does not determine it. The position on the contact face is that of the
/// first region; on the sides there is none (push_along.h).
[[nodiscard]] FingerContact finger_contact(const ContactEvidence& evidence,
                                           const FaceShape& shape,
                                           std::optional<PushedFace> before);

/// Mean over all markers of the position of their columns along the face, mm. This is the skin's
/// position in the coordinates of PositionOnFinger::along_mm, whose origin moves as the finger
/// bends. nullopt: there are no markers.
[[nodiscard]] std::optional<double> skin_along_mm(const Markers& markers, const FaceShape& shape);

}  // namespace alltact
