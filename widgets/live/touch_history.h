// Recent forces and contacts of a finger, by the frames' capture times.
#pragma once

#include "calibration/live/live_finger.h"
#include "core/sensing/frame_result.h"
#include "widgets/language.h"

#include <QDateTime>
#include <QString>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// A value type of bounded size: the last kLength_s, at most one force in each kSlot_s.
class TouchHistory {
 public:
  static constexpr double kLength_s = 30.0, kSlot_s = 0.02;
  /// Between frames further apart than this nothing is known.
  static constexpr double kMaxGap_s = 1.0;

  struct ForceReading {
    double time_s = 0;
    std::optional<Force> force;  ///< empty: not estimated, or frames are missing before it
  };
  struct Contact {
    double from_s = 0, to_s = 0;  ///< by capture times; to_s: of its last frame
    PushedFace face = PushedFace::kContact;
    bool has_ended = false;
  };
  struct Slip {
    double from_s = 0, to_s = 0;
  };
  /// Slip in frames closer than this is one slip.
  static constexpr double kSlipMerge_s = 0.1;

  /// time_s: of capture, of any clock. A time before the last one clears the history.
  void add(const FrameResult& result, double time_s);
  void forget() { *this = TouchHistory(); }

  [[nodiscard]] const std::deque<ForceReading>& forces() const { return forces_; }
  [[nodiscard]] const std::deque<Contact>& contacts() const { return contacts_; }  ///< oldest first
  [[nodiscard]] const std::deque<Slip>& slips() const { return slips_; }
  [[nodiscard]] bool has_slipped(const Contact& contact) const;
  /// Time of the latest frame; nullopt before the first.
  [[nodiscard]] std::optional<double> now_s() const { return now_s_; }
  /// At least one retained frame has a force.
  [[nodiscard]] bool has_forces() const;

 private:
  void add_force(const std::optional<Force>& force, bool is_after_gap);
  void add_contact(const std::optional<FingerContact>& contact, bool is_after_gap);
  void add_slip();

  std::optional<double> now_s_;
  std::deque<ForceReading> forces_;
  std::deque<Contact> contacts_;
  std::deque<Slip> slips_;
};

/// A force that is subtracted as zero.
struct ForceZero {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  /// Uncertainty of the reading: half widths as in Force.
  Eigen::Vector3d half_90_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_95_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d sd_N = Eigen::Vector3d::Zero();
  bool has_contact = false;  ///< something was in contact, so its force counts as zero
  bool operator==(const ForceZero&) const = default;
};

/// Mean of the readings of the last kZeroSpan_s; nullopt: there is none, or one is out of range.
[[nodiscard]] std::optional<ForceZero> present_zero(const TouchHistory& history);
inline constexpr double kZeroSpan_s = 0.5;

/// The force minus the zero. Half widths are the root of the sum of squares, as for independent
/// errors. Errors shared by both, like those of one model, make this wider than necessary.
[[nodiscard]] Force zeroed(Force force, const std::optional<ForceZero>& zero);

// Zero of a finger's forces, valid while the program runs.

/// A zero with its finger and force model; it does not apply to others.
struct SessionZero {
  ForceZero zero;
  QDateTime since;
  std::filesystem::path finger;  ///< folder
  std::string model;             ///< Finger::force_model
  bool operator==(const SessionZero&) const = default;
};

// Text about the contact.

/// Rich text: face and duration of the contact, slip, position on the finger and direction with
/// their standard deviations, extent. Without contact: when the last one ended. `history`: null
/// where frames are not consecutive.
[[nodiscard]] QString contact_words(const FrameResult& result, const TouchHistory* history);

/// Face and force, as measured, on one line; empty where neither is known.
[[nodiscard]] QString brief_contact_words(const FrameResult& result);

/// Origins of the figures, for a tool tip.
[[nodiscard]] QString contact_words_help();

// Explains why there is no force.

/// Rich text, with what to do.
[[nodiscard]] QString no_force_reason(const FingerStatus& status);
[[nodiscard]] bool has_force_model(const FingerStatus& status);

}  // namespace alltact
