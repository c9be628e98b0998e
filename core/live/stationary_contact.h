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
};
/// nullopt where nothing presses.
[[nodiscard]] std::optional<DarkPatch> dark_patch(const FrameResult& result);

/// Says once of every contact that it holds still: neither its place nor its depth has changed for
/// half a second. The next is said when it has left, or moved on by 2 mm.
class StationaryContactDetector {
 public:
  static constexpr double kHold_s = 0.4;
  static constexpr double kMost_mm = 0.35;     ///< of movement meanwhile
  static constexpr double kMostChange = 0.06;  ///< of darkness, as a part of it
  static constexpr double kApart_mm = 2;

  /// time_s: of any clock. True: take this frame.
  [[nodiscard]] bool add(const std::optional<DarkPatch>& patch, double time_s);
  void begin() { *this = StationaryContactDetector(); }

 private:
  struct Seen {
    double time_s;
    DarkPatch patch;
  };
  std::deque<Seen> seen_;
  std::optional<DarkPatch> taken_;
};

}  // namespace alltact
