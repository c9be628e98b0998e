// Takes a press from a live stream once ball and finger are still.
#pragma once

#include "calibration/presses/held_frames.h"
#include "core/live/stationary_contact.h"

#include <optional>

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
                                         const std::optional<DarkPatch>& contact,
                                         double time_s);
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

}  // namespace alltact
