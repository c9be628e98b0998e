// Detects when a contact is stationary, so that both hands are free to hold finger and ball.
#pragma once

#include "core/sensing/frame_result.h"

#include <deque>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// Position of the darkest patch of the face, and its darkness.
struct DarkPatch {
  Eigen::Vector2d position_mm = Eigen::Vector2d::Zero();  ///< along and across the face
  double darkness = 0;  ///< brightness difference; for a calibrated finger, depth in mm
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< its middle, in the oriented image
  /// Radius, mm, of a disc with the area on the face of the connected region around the middle that
  /// is at least kDiscLevel as dark; 0 where that is unknown.
  double disc_radius_mm = 0;
};
/// nullopt without contact.
[[nodiscard]] std::optional<DarkPatch> dark_patch(const FrameResult& result);

/// State of the current contact.
enum class HoldState {
  kNothing = 1,  ///< no contact
  kMoves,
  kHolds,  ///< stationary so far
  kTaken,  ///< already reported: it has neither left nor moved on
};
struct Hold {
  HoldState state = HoldState::kNothing;
  double hold_fraction = 0;  ///< fraction of the required time at rest, [0, 1]
  double moved_mm = 0;       ///< during the last of that time
};

/// Reports each contact once when it is stationary: position and depth have not changed for half a
/// second. The next report follows when the contact has left, or moved by 2 mm.
class StationaryContactDetector {
 public:
  static constexpr double kHold_s = 0.5;
  static constexpr double kMaxMovement_mm = 0.35;  ///< maximum movement meanwhile
  static constexpr double kMaxChange = 0.06;       ///< maximum change of darkness, relative
  static constexpr double kMinMovement_mm = 2;
  static constexpr double kMaxGap_s = 1;        ///< maximum gap between frames; what happens in a
                                                ///< longer one is unknown
  static constexpr std::size_t kMinFrames = 4;  ///< minimum number of stationary frames

  /// time_s: of any clock. True: take this frame.
  [[nodiscard]] bool add(const std::optional<DarkPatch>& patch, double time_s);
  [[nodiscard]] const Hold& hold() const { return hold_; }
  void begin() { *this = StationaryContactDetector(); }

 private:
  struct Seen {
    double time_s;
    DarkPatch patch;
  };
  std::deque<Seen> seen_;
  std::optional<DarkPatch> taken_;
  Hold hold_;
};

}  // namespace alltact
