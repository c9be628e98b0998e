// When a contact begins and ends, and whether what touches slips: over the frames of one source.
#pragma once

#include <deque>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// A contact begins when frames have told of one (strength 1 and more, ContactSigns) for kOnset_s,
/// and ends when they have told of less than kRelease of that for kRelease_s. In between it stays
/// what it was. Durations are in seconds, so that neither the frame rate nor lost frames matter; of
/// frames without a time each counts by itself. The first frame counts at once, as does the first
/// after a pause of more than kMostGap_s or after time went back.
///
/// What touches slips when its place has moved against the skin within kWindow_s by more than
/// kSlipSds standard deviations of that, and by more than kLeastSlip_mm, as which a growing dent
/// and the markers' distance behind the face can pass. Rolling is told as slipping: both move the
/// contact over the skin.
class ContactState {
 public:
  static constexpr double kRelease = 0.6;
  static constexpr double kOnset_s = 0.015, kRelease_s = 0.05, kMostGap_s = 1.0;
  static constexpr double kWindow_s = 0.25, kSlipSds = 5.0, kLeastSlip_mm = 0.4;

  struct Seen {
    std::optional<double> time_s;  ///< of any clock
    double strength = 0;
    /// Of the contact, along the face and across it, and its covariance; absent: not told.
    std::optional<Eigen::Vector2d> place_mm;
    Eigen::Matrix2d place_covariance_mm2 = Eigen::Matrix2d::Zero();
    /// How the skin lies along the face, in the same coordinates (skin_along_mm).
    double skin_along_mm = 0;
  };
  struct Told {
    bool is_touched = false, is_new = false;
    std::optional<double> held_s;            ///< since it began; absent without times
    std::optional<bool> is_slipping;         ///< absent: untouched, no places, or no times
    std::optional<Eigen::Vector2d> slip_mm;  ///< over the skin, within the window
  };
  [[nodiscard]] Told add(const Seen& seen);
  void forget() { *this = ContactState(); }

 private:
  void follow(const Seen& seen, Told& told);
  void look_for_slip(const Seen& seen, Told& told);

  struct Place {
    double time_s;
    Eigen::Vector2d on_skin_mm;
    Eigen::Matrix2d covariance_mm2;
  };
  bool has_begun_ = false, is_touched_ = false;
  std::optional<double> last_s_, began_s_;
  std::optional<double> strong_s_, weak_s_;  // since when
  std::deque<Place> places_;
};

}  // namespace alltact
