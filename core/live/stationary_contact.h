// Notices when a contact holds still, so that both hands can hold finger and ball.
#pragma once

#include "core/sensing/pipeline.h"

#include <deque>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// Where the darkest patch of the face lies, and how dark it is.
struct DarkPatch {
  Eigen::Vector2d place_mm = Eigen::Vector2d::Zero();  ///< along and across the face
  double darkness = 0;  ///< brightness difference; of a calibrated finger depth in mm
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< its middle, in the oriented picture
  /// Of the disc that is as large on the face as what hangs together with the middle and is at
  /// least kDiscLevel as dark, mm; 0 where that is not seen.
  double disc_radius_mm = 0;
};
/// nullopt where nothing presses.
[[nodiscard]] std::optional<DarkPatch> dark_patch(const FrameResult& result);

/// How a contact is held now.
enum class HoldState {
  kNothing = 1,  ///< nothing presses
  kMoves,
  kHolds,  ///< still so far
  kTaken,  ///< said already: it has neither left nor moved on
};
struct Hold {
  HoldState state = HoldState::kNothing;
  double part = 0;      ///< of the time it has to hold still, [0, 1]
  double moved_mm = 0;  ///< over the last of that time
};

/// Says once of every contact that it holds still: neither its place nor its depth has changed for
/// half a second. The next is said when it has left, or moved on by 2 mm.
class StationaryContactDetector {
 public:
  static constexpr double kHold_s = 0.5;
  static constexpr double kMost_mm = 0.35;     ///< of movement meanwhile
  static constexpr double kMostChange = 0.06;  ///< of darkness, as a part of it
  static constexpr double kApart_mm = 2;
  static constexpr double kMostGap_s = 1;    ///< between frames; nobody knows what lies in more
  static constexpr std::size_t kFewest = 4;  ///< frames that show it still

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
