// Beginning and end of a contact, and whether the object slips: over the frames of one source.
#pragma once

#include <deque>
#include <optional>

#include <Eigen/Core>

namespace alltact {

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

}  // namespace alltact
