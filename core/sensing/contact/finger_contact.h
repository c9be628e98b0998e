// What touches the finger: which face, which way it is pushed, and where on the finger.
#pragma once

#include "core/message.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/contact/push_along.h"
#include "core/sensing/contact/tip_way.h"
#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// On the finger, mm. On the contact face that of the skin which is pressed deepest
/// (ContactRegion::deepest_on_face_mm); on the back where the markers' motion tells that it is
/// pushed (push_along.h), which tells neither across nor depth. Standard deviations hold the
/// picture's noise, where the face's end at the base is seen, and how well the face's distance and
/// the depth are known; not the lens.
struct PlaceOnFinger {
  double along_mm = 0;              ///< along the face from its base (FaceShape::length_at)
  std::optional<double> across_mm;  ///< from its middle line towards +y
  std::optional<double> depth_mm;   ///< the deepest, along z
  /// Absent where the region tells no covariance; along_sd_mm also where the base's end is not
  /// seen, so that along_mm counts from the first column that shows the face.
  std::optional<double> along_sd_mm, across_sd_mm, depth_sd_mm;
  std::uint8_t limits = 0;  ///< bits of DepthLimit: with kLayerLimit depth_mm is a least value
};

struct FingerContact {
  /// The contact face where something is pressed into it; else that from which the finger gave way.
  PushedFace face = PushedFace::kContact;
  /// Unit, camera frame: the way that the finger gave way (tip_way), or where it did not, the
  /// normal into the contact face at the place. Absent: neither is told.
  std::optional<Eigen::Vector3d> direction;
  /// Within the finger's section; absent where the direction is the face's normal.
  std::optional<double> direction_sd_deg;
  std::optional<PlaceOnFinger> place;
  Message no_place;              ///< why there is none; empty when there is one
  bool is_new = false;           ///< it began in this frame
  std::optional<double> held_s;  ///< since it began; absent where frames have no time
  /// The thing moves over the skin (contact_state.h); absent where that cannot be told.
  std::optional<bool> is_slipping;
};

/// What a frame tells of a contact.
struct ContactSigns {
  const Push* push = nullptr;  ///< null: no marker tells one
  double push_threshold_px = 0;
  std::optional<TipWay> way;
  std::optional<AlongFinger> along_back;                ///< of a push on the back
  const std::vector<ContactRegion>* regions = nullptr;  ///< null: no depth was told
  /// 1 where a push begins to be one (push.h) or a region is as deep as face_touch.h asks for, the
  /// larger of both.
  [[nodiscard]] double strength() const;
  [[nodiscard]] double push_strength() const;
  [[nodiscard]] double depth_strength() const;
};

/// Covariance of a region's place on the face, along it and across it. nullopt: its own is not
/// told.
[[nodiscard]] std::optional<Eigen::Matrix2d> place_covariance_on_face_mm2(
    const ContactRegion& region, const FaceShape& shape);

/// From which face the finger gave way.
[[nodiscard]] PushedFace face_of_way(const TipWay& way);

/// Of a frame with a contact. `before`: the face of the same contact in the frame before, which is
/// kept where this one does not tell it. The place on the contact face is that of the first
/// region; on the sides there is none (push_along.h).
[[nodiscard]] FingerContact finger_contact(const ContactSigns& signs,
                                           const FaceShape& shape,
                                           std::optional<PushedFace> before);

/// Mean over all markers of where their columns lie along the face, mm: how the skin lies in the
/// coordinates of PlaceOnFinger::along_mm, whose beginning moves as the finger bends. nullopt:
/// none.
[[nodiscard]] std::optional<double> skin_along_mm(const Markers& markers, const FaceShape& shape);

}  // namespace alltact
