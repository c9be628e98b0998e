// Contact of the finger: which face, in which direction it is pushed, and at which position.
#pragma once

#include "core/base/message.h"
#include "core/finger/finger.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_shape.h"

#include <array>
#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Position on the finger, mm. On the contact face it is that of the skin which is pressed deepest
/// (ContactRegion::deepest_on_face_mm). On the back it is estimated from the markers' motion
/// (push.h), which determines neither across nor depth. Standard deviations include the
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
  /// Unit vector, camera frame: the direction of the deflection (push.h). Without a
  /// deflection, the normal into the contact face at the position. Empty: neither is known.
  std::optional<Eigen::Vector3d> direction;
  /// Within the finger's section; empty where the direction is the face's normal.
  std::optional<double> direction_sd_deg;
  std::optional<PositionOnFinger> position;
  Message no_position;           ///< reason why there is no position; empty when there is one
  bool is_new = false;           ///< it began in this frame
  std::optional<double> held_s;  ///< since it began; empty where frames have no time
  /// The object moves over the skin; empty where this is unknown.
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
  /// (push.h), or the depth of the contact.
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
/// first region; on the sides there is none (push.h).
[[nodiscard]] FingerContact finger_contact(const ContactEvidence& evidence, const FaceShape& shape,
                                           std::optional<PushedFace> before);

/// Mean over all markers of the position of their columns along the face, mm. This is the skin's
/// position in the coordinates of PositionOnFinger::along_mm, whose origin moves as the finger
/// bends. nullopt: there are no markers.
[[nodiscard]] std::optional<double> skin_along_mm(const Markers& markers, const FaceShape& shape);

// Whether something presses on the contact face: yes, no, or unknown.

/// State of the contact face.
enum class FaceContact {
  kUnknown = 1,  ///< no face in the image, no finger, or its first frames
  kFree,
  kInContact,
};

inline constexpr double kContactDepth_mm = 0.15;  ///< above noise and permanent indentations

/// From depth: kInContact where a region is deeper than kContactDepth_mm.
[[nodiscard]] FaceContact face_contact(const std::vector<ContactRegion>& regions);

/// Before calibration, from a dark area against the reference: kInContact where more than 0.1 % of
/// the measured face is darker by 12 %; kUnknown where nothing was measured.
[[nodiscard]] FaceContact face_contact(const Difference& difference);

// Beginning and end of a contact, and whether the object slips: over the frames of one source.

/// A contact begins when frames have shown one (strength 1 and more, ContactEvidence) for kOnset_s.
/// It ends when they have shown less than kRelease of that for kRelease_s. In between the state
/// does not change. Durations are in seconds, so that neither the frame rate nor lost frames
/// matter; each frame without a time counts by itself. The first frame counts at once, as does the
/// first after a pause of more than kMaxGap_s or after time went back.
///
/// The object slips when its position has moved against the skin within kWindow_s by more than
/// kSlipSds standard deviations and by more than kMinSlip_mm. Growing indentations and the markers'
/// distance behind the face can cause apparent motion up to kMinSlip_mm. Rolling is reported as
/// slipping: both move the contact over the skin.
class ContactState {
 public:
  static constexpr double kRelease = 0.6;
  static constexpr double kOnset_s = 0.015, kRelease_s = 0.05, kMaxGap_s = 1.0;
  static constexpr double kWindow_s = 0.25, kSlipSds = 5.0, kMinSlip_mm = 0.4;

  struct Observation {
    std::optional<double> time_s;  ///< of any clock
    double strength = 0;
    /// Of the contact, along the face and across it, and its covariance; empty: unknown.
    std::optional<Eigen::Vector2d> position_mm;
    Eigen::Matrix2d position_covariance_mm2 = Eigen::Matrix2d::Zero();
    /// Position of the skin along the face, in the same coordinates (skin_along_mm).
    double skin_along_mm = 0;
  };
  struct Estimate {
    bool has_contact = false, is_new = false;
    std::optional<double> held_s;            ///< since it began; empty without times
    std::optional<bool> is_slipping;         ///< empty: no contact, no positions, or no times
    std::optional<Eigen::Vector2d> slip_mm;  ///< over the skin, within the window
  };
  [[nodiscard]] Estimate add(const Observation& seen);
  void forget() { *this = ContactState(); }

 private:
  void update_contact(const Observation& seen, Estimate& estimate);
  void detect_slip(const Observation& seen, Estimate& estimate);

  struct Sample {
    double time_s;
    Eigen::Vector2d on_skin_mm;
    Eigen::Matrix2d covariance_mm2;
  };
  bool has_begun_ = false, has_contact_ = false;
  std::optional<double> last_s_, began_s_;
  std::optional<double> strong_s_, weak_s_;  // since when
  std::deque<Sample> samples_;
};

// Tracks the contact of a finger over the frames of a source.

/// All evidence of one frame: the observation, and the contact for each face that the frame before
/// may have had.
struct FrameContacts {
  ContactState::Observation seen;
  std::array<FingerContact, 5> by_face;  ///< 0: none before; else a PushedFace
};

/// Stores the contact of the frames before.
class FingerContactTracker {
 public:
  struct FrameInput {
    std::optional<double> time_s;               ///< of any clock
    const FaceShape* shape = nullptr;           ///< required
    const Markers* markers = nullptr;           ///< null: none were found
    const Push* push = nullptr;                 ///< null: no marker shows one
    const ContactSettings* settings = nullptr;  ///< required with `push`
    /// displacement_covariance_px2(); required with `push`
    const Eigen::MatrixXd* displacement_cov_px2 = nullptr;
    const std::vector<ContactRegion>* regions = nullptr;  ///< null: there is no depth
  };
  /// nullopt: there is no contact.
  [[nodiscard]] std::optional<FingerContact> operator()(const FrameInput& frame);
  /// Uses no state: for frames that are measured independently of those before them.
  [[nodiscard]] static FrameContacts single_frame(const FrameInput& frame);
  /// Resets the state: the next frame does not follow the last one in time.
  void forget() { *this = FingerContactTracker(); }

 private:
  ContactState state_;
  std::optional<PushedFace> face_;
};

// Detects contact before there is a reference recording: every patch of skin is compared with its
// surroundings, and their contrast with that of the frames before.

/// A patch that is darker against its surroundings than before.
struct ReferenceFreeContact {
  double darker = 0;    ///< 0.1: by 10 %
  double along_mm = 0;  ///< from the base
};

/// Bending changes the light evenly over a centimetre, a contact darkens a few millimetres. Marked
/// or dirty skin is so in every frame. Two kinds of contact are not detected. One lasts since the
/// first frame, until it ends and its patch is learnt again. The other presses evenly over more
/// than a centimetre. The study of the complete recording is more sensitive.
class ReferenceFreeContactDetector {
 public:
  /// nullopt: no contact, or these are the first frames. `grey`: CV_8UC1, the shape's width.
  [[nodiscard]] std::optional<ReferenceFreeContact> operator()(const cv::Mat& grey,
                                                               const FaceShape& shape);
  /// Enough frames have been seen for a comparison.
  [[nodiscard]] bool is_ready() const { return frames_ >= kFirstFrames; }
  /// Resets the state: the next frame shows another finger, or another light.
  void forget();

 private:
  static constexpr int kFirstFrames = 5;
  struct Skin {  // one patch, over the frames without contact on it
    int frames = 0;
    double typical = 0, variance = 0;
  };
  /// Returns false where the patch is darker than it varies without contact.
  static bool learn(Skin& skin, double now);

  std::vector<Skin> skin_;
  int frames_ = 0;
};

}  // namespace alltact
