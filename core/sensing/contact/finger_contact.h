// Contact of the finger: which face, in which direction it is pushed, and at which position.
//
// NOTIONS OF CONTACT
// The program has four. Each follows from those above it or from images, with these thresholds:
//
//   name (file)          evidence, threshold and unit; purpose
//   ContactRegion        depth: cells of 4 x 4 px deeper on average than 0.1 mm (setting
//   (contact_regions.h)  contact_threshold_mm) and 4 sd of contact-free skin; where and how deep
//   ContactEvidence      what one frame shows by itself; strength 1 is the threshold:
//   (here)               - depth: the deepest region, 0.15 mm (kContactDepth_mm)
//                        - push: sum of the markers' displacements from rest, px:
//                          ContactSettings::threshold_px, which installing a reference sets to 5 sd
//                          (reference_recording.cpp)
//                        - is_face_pressed: the same depth; without a mapping 0.1 % of the face
//                          darker than its reference by 12 %; without a reference a patch of 2 mm
//                          darker than in earlier frames by 5 % and 6 sd
//   FingerContact        evidence of the frames in their order: begins at strength 1 for 15 ms,
//   (here)               ends below 0.6 for 50 ms; results, live and of recordings
//   FrameContact         brightness of a patch against the rest of a recording: 1 % darker over
//   (contact_search.h)   3 mm, 0.7 % over 5 mm, 0.5 % over 9 mm, and 9 sd; frames that a reference
//                        excludes
//
// Robust fits exclude pressed skin as outliers without detecting a contact (light_gain.h,
// depth_map.cpp). Calibration knows that a ball or punch presses, and finds its outline (press.h,
// contact_model.h, step_press.cpp).
//
// Elsewhere "untouched" means the skin as the reference shows it, whatever presses now.
#pragma once

#include "core/base/message.h"
#include "core/finger/finger.h"
#include "core/sensing/contact/contact_regions.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/depth/depth_map.h"
#include "core/sensing/face/face_shape.h"

#include <algorithm>
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

inline constexpr double kContactDepth_mm = 0.15;  ///< above noise and permanent indentations

/// What one frame shows of the first region.
struct ContactIndentation {
  PositionOnFinger position;
  std::optional<Eigen::Vector3d> direction;  ///< unit normal into the face, camera frame
  /// Centre on the skin, mm: along it from the mean of the markers, and across the face. Empty
  /// where the region has no covariance.
  std::optional<Eigen::Vector2d> on_skin_mm;
  Eigen::Matrix2d on_skin_covariance_mm2 = Eigen::Matrix2d::Zero();
};

/// What one frame shows of the finger's tip (TipDisplacement).
struct ContactDeflection {
  PushedFace face = PushedFace::kContact;                ///< from which it was deflected
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< unit, camera frame
  double direction_sd_deg = 0;
  std::optional<PositionOnFinger> position;  ///< of a push on the back, where it is known
};

/// What one frame shows by itself, whichever contact the frames before had. Strengths have no unit:
/// 1 is the threshold.
struct ContactEvidence {
  std::optional<double> time_s;  ///< of any clock
  std::optional<double> depth;   ///< strength of the greatest depth; empty: there is no depth
  double push = 0;               ///< strength of the deflection; 0: no marker shows one
  std::optional<ContactIndentation> indentation;  ///< empty: there is no region
  /// Empty where the push is below FingerContactTracker::kRelease, or of unknown direction.
  std::optional<ContactDeflection> deflection;
  /// Something presses into the contact face, by the best measure that there is (table above).
  /// Empty: unknown, as no face is seen or these are the first frames.
  std::optional<bool> is_face_pressed;

  [[nodiscard]] double strength() const { return std::max(push, depth.value_or(0)); }

  /// Adds what the depth shows. `markers`: may be null.
  void add_regions(const std::vector<ContactRegion>& regions, const FaceShape& shape,
                   const Markers* markers);
  /// Adds what the markers show, after the depth.
  ///   displacement_cov_px2: displacement_covariance_px2()
  void add_push(const Push& push, const ContactSettings& settings, const Markers& markers,
                const FaceShape& shape, const Eigen::MatrixXd& displacement_cov_px2);
};

/// Whether something presses into the contact face, before calibration: more than 0.1 % of the
/// measured face is darker than its reference by 12 %. Empty where nothing was measured.
[[nodiscard]] std::optional<bool> is_face_dark(const Difference& difference);

/// Tracks the contact of a finger over the frames of one source, in their order.
///
/// A contact begins when frames have shown one (strength 1 and more) for kOnset_s. It ends when
/// they have shown less than kRelease of that for kRelease_s. In between the state does not change.
/// Durations are in seconds, so that neither the frame rate nor lost frames matter; each frame
/// without a time counts by itself. The first frame counts at once, as does the first after a pause
/// of more than kMaxGap_s or after time went back.
///
/// The face of a contact is that of its first region, else that of the deflection. A frame that
/// shows neither has the face of the frame before. The position on the contact face is that of the
/// first region; on the sides there is none (push.h).
///
/// One contact has one face. Where frames have shown another face for kRelease_s, another contact
/// begins, with the first of them. A region of strength 1 begins one at once.
///
/// The object slips when its position has moved against the skin within kWindow_s by more than
/// kSlipSds standard deviations and by more than kMinSlip_mm. Growing indentations and the markers'
/// distance behind the face can cause apparent motion up to kMinSlip_mm. Rolling is reported as
/// slipping: both move the contact over the skin.
class FingerContactTracker {
 public:
  static constexpr double kRelease = 0.6;
  static constexpr double kOnset_s = 0.015, kRelease_s = 0.05, kMaxGap_s = 1.0;
  static constexpr double kWindow_s = 0.25, kSlipSds = 5.0, kMinSlip_mm = 0.4;

  /// False: the frames are not consecutive, and each counts by itself.
  explicit FingerContactTracker(bool is_continuous = true) : is_continuous_(is_continuous) {}

  /// The contact in the next frame; nullopt: there is none. A frame without evidence (it could not
  /// be measured) has none and changes nothing.
  [[nodiscard]] std::optional<FingerContact> operator()(const std::optional<ContactEvidence>& seen);
  /// Resets the state: the next frame does not follow the last one in time.
  void forget() { *this = FingerContactTracker(is_continuous_); }

 private:
  [[nodiscard]] bool holds_for(double duration_s, bool holds, std::optional<double> time_s,
                               std::optional<double>& since) const;
  [[nodiscard]] bool begins(const ContactEvidence& seen);
  [[nodiscard]] bool changes_face(const ContactEvidence& seen);
  [[nodiscard]] std::optional<bool> is_slipping(const ContactEvidence& seen);

  struct Sample {
    double time_s;
    Eigen::Vector2d on_skin_mm;
    Eigen::Matrix2d covariance_mm2;
  };
  bool is_continuous_;
  bool has_begun_ = false, has_contact_ = false;
  std::optional<PushedFace> face_;  // of the present contact
  std::optional<double> last_s_, began_s_;
  std::optional<double> strong_s_, weak_s_, other_face_s_;  // since when
  std::deque<Sample> samples_;
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
