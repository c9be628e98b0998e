// Checks the rig before a recording: focus at base and tip, brightness and steadiness of the light,
// dots that are found, each with advice.
#pragma once

#include "core/base/message.h"
#include "core/sensing/frame_result.h"

#include <deque>
#include <optional>
#include <vector>

namespace alltact {

enum class RigItem { kFocusBase = 1, kFocusTip, kBrightness, kLamp, kDots };
enum class RigState {
  kWaiting = 1,  ///< unknown so far
  kFine,
  kDoubtful,  ///< works, with limits
  kBad,
};
struct RigFinding {
  RigItem item = RigItem::kDots;
  RigState state = RigState::kWaiting;
  Message sentence;  ///< the figure, without a full stop
  Message advice;    ///< an imperative; empty: no action needed
};

/// Width of the face's edges, px: the contrast across over the steepest slope, median over the
/// third of the finger at its base, or at its tip. nullopt: too few edges are seen there. A sharp
/// image has about 1.5 to 2.5.
[[nodiscard]] std::optional<double> edge_sharpness_px(const FrameResult& result, bool at_tip);

/// Receives the frames of a live source. Not thread-safe.
class RigCheck {
 public:
  static constexpr double kLamp_s = 10;  ///< duration of the watch over the lamp
  static constexpr double kSharp_px = 3.5, kBlurred_px = 6;
  /// Fractions of the face's pixels that are saturated.
  static constexpr double kFewSaturated = 0.001, kManySaturated = 0.02;
  static constexpr double kDark = 60, kTooDark = 35;  ///< mean grey of the face's brightest tenth
  /// Relative change of the skin's mean brightness over kLamp_s.
  static constexpr double kSteady = 0.01, kUnsteady = 0.03;

  void begin() { *this = RigCheck(); }
  /// time_s: of any clock. Motion of the finger restarts the watch over the lamp.
  void add(const FrameResult& result, double time_s);
  /// In the order of RigItem. `expected_dots`: the finger's number of dots; 0: none, or unknown.
  [[nodiscard]] std::vector<RigFinding> findings(int expected_dots) const;
  /// Completed fraction of the watch over the lamp, [0, 1].
  [[nodiscard]] double lamp_part() const;

 private:
  struct Light {
    double time_s, mean;
  };
  void watch_lamp(const FrameResult& result, double time_s);
  [[nodiscard]] RigFinding focus(RigItem item, const std::optional<double>& width_px) const;
  [[nodiscard]] RigFinding brightness() const;
  [[nodiscard]] RigFinding lamp() const;
  [[nodiscard]] RigFinding dots(int expected) const;

  bool has_frame_ = false, has_face_ = false;
  std::optional<double> base_px_, tip_px_;  // smoothed over frames
  double saturated_ = 0, bright_ = 0;
  int seen_dots_ = 0;
  std::deque<Light> lights_;
  Markers last_markers_;
  std::optional<Eigen::Vector2d> last_end_;  // end of the face, where there are no markers
};

}  // namespace alltact
