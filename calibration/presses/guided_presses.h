// Presses from a live stream: takes one when ball and finger are still, and plans the next.
#pragma once

#include "calibration/presses/press_input.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/stationary_contact.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Receives every frame of a source. As soon as a press is requested, it takes the mean of enough
/// frames that are the same. Frames of a moving finger are no press: the ball would be fitted to a
/// position where it never was.
class PressTaker {
 public:
  static constexpr std::size_t kBurst = 16;  ///< frames of a press; see HeldFrames
  static constexpr std::size_t kFewest = 4;  ///< of a source that is slow
  static constexpr double kHeld_s = 0.5;     ///< enough where kBurst takes longer
  static constexpr double kTimeout_s = 5.0;

  struct Taken {
    FramePtr frame;  ///< the mean, with the last one's name, time and settings
    std::size_t of = 0;
  };
  enum class State {
    kIdle = 1,
    kWaits,    ///< until ball and finger are still
    kRefused,  ///< they were not within kTimeout_s
  };

  /// Requests a press. Returns it at once where the last frames are still; otherwise see() or end()
  /// does.
  [[nodiscard]] std::optional<Taken> request(double time_s);
  /// Adds the next frame, and the contact that it shows. time_s: of any monotonic clock. With
  /// flickering light no two frames are the same; then a stationary contact is taken as it is.
  [[nodiscard]] std::optional<Taken> see(const FramePtr& frame,
                                         const std::optional<DarkPatch>& contact, double time_s);
  /// The stream has ended: the last frame is taken.
  [[nodiscard]] std::optional<Taken> end();
  /// Resets frames and request: another finger, or no viewer.
  void forget();

  [[nodiscard]] State state() const { return state_; }
  /// Fraction of a burst that is complete, [0, 1].
  [[nodiscard]] double held_part() const;

 private:
  [[nodiscard]] bool is_enough() const;
  [[nodiscard]] Taken take(const std::vector<FramePtr>& frames);

  HeldFrames held_{kBurst};
  FramePtr newest_;              // null: none
  std::vector<FramePtr> alike_;  // with the newest
  State state_ = State::kIdle;
  double requested_s_ = 0;
  StationaryContactDetector contact_;  // since the request
};

// Positions and depths of the first six presses of an uncalibrated finger, so that a live view can
// show the next one.

struct PressTarget {
  Eigen::Vector2d position_mm = Eigen::Vector2d::Zero();  ///< FaceShape::position_mm
  double depth_mm = 0;                                    ///< along the normal
};

/// Base, middle and tip, each twice: once on each side of the middle line, from two fifths to seven
/// tenths of the layer deep. Presses of different depths determine the mapping's lower end
/// (calibrate.h). Over the visible part of the face; empty where none is.
[[nodiscard]] std::vector<PressTarget> first_presses(const FaceShape& shape);

/// The first of `targets` without a press at `made_mm`. A press counts for the target nearest to
/// it; two presses at one position count once.
[[nodiscard]] std::optional<PressTarget> next_press(const std::vector<PressTarget>& targets,
                                                    const std::vector<Eigen::Vector2d>& made_mm);

/// The pixel of a position on the face; the nearest one where that is not in the image. nullopt: no
/// face is visible.
[[nodiscard]] std::optional<Eigen::Vector2d> pixel_of_position(const FaceShape& shape,
                                                               const Eigen::Vector2d& position_mm);

enum class PressProgress {
  kDeeper = 1,
  kEnough,   ///< from 0.85 times the target
  kTooDeep,  ///< beyond 1.4 times, or 0.8 of the layer, where silicone tears and mappings end
};
[[nodiscard]] PressProgress press_progress(double depth_mm, double target_mm, double layer_mm);

}  // namespace alltact
