// What a finger felt of late: its forces and its contacts, by the frames' own times.
#pragma once

#include "core/sensing/pipeline.h"

#include <deque>
#include <optional>
#include <vector>

namespace alltact {

/// A value. Bounded: the last kLength_s, at most one force in kSlot_s.
class TouchHistory {
 public:
  static constexpr double kLength_s = 30.0, kSlot_s = 0.02;
  /// Frames further apart say nothing of the time between them.
  static constexpr double kLongestGap_s = 1.0;

  struct ForceReading {
    double time_s = 0;
    std::optional<Force> force;  ///< absent: it could not be told, or frames are missing before
  };
  struct Contact {
    double from_s = 0, to_s = 0;  ///< by the frames that came; to_s: when it was seen last
    PushedFace face = PushedFace::kContact;
    bool has_ended = false;
  };
  struct Slip {
    double from_s = 0, to_s = 0;
  };
  /// Frames that tell of slip so near to each other tell of one.
  static constexpr double kOneSlip_s = 0.1;

  /// time_s: of capture, of any clock. Time that goes back begins it anew.
  void add(const FrameResult& result, double time_s);
  void forget() { *this = TouchHistory(); }

  [[nodiscard]] const std::deque<ForceReading>& forces() const { return forces_; }
  [[nodiscard]] const std::deque<Contact>& contacts() const { return contacts_; }  ///< oldest first
  [[nodiscard]] const std::deque<Slip>& slips() const { return slips_; }
  [[nodiscard]] bool has_slipped(const Contact& contact) const;
  /// Of the latest frame; nullopt before the first.
  [[nodiscard]] std::optional<double> now_s() const { return now_s_; }
  /// A force was told of some frame that is kept.
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

/// A force that counts as none from now on.
struct ForceZero {
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  /// How far the reading may be off: half widths as in Force.
  Eigen::Vector3d half_90_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_95_N = Eigen::Vector3d::Zero();
  Eigen::Vector3d sd_N = Eigen::Vector3d::Zero();
  bool is_touched = false;  ///< something touched the finger then: what it pressed counts as none
  bool operator==(const ForceZero&) const = default;
};

/// Mean of the readings of the last kZeroSpan_s, all of them in range; nullopt: there is none.
[[nodiscard]] std::optional<ForceZero> present_zero(const TouchHistory& history);
inline constexpr double kZeroSpan_s = 0.5;

/// The force less the zero. Both err, and how much of that they share is not known: half widths are
/// the root of the sum of squares, as of readings that share nothing. What they do share, like a
/// model that errs alike in both, makes that wider than need be.
[[nodiscard]] Force zeroed(Force force, const std::optional<ForceZero>& zero);

}  // namespace alltact
