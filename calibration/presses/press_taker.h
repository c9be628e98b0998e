// A press from a live picture: not before ball and finger hold still.
#pragma once

#include "calibration/presses/held_frames.h"
#include "core/live/stationary_contact.h"

#include <optional>

namespace alltact {

/// Is shown every frame of a source, and takes the mean of those that show the same as soon as a
/// press is wanted and they are enough of them: a picture of a moving finger is none, because the
/// ball would be fitted to a place where it never was.
class PressTaker {
 public:
  static constexpr std::size_t kBurst = 16;  ///< frames of a press; see HeldFrames
  static constexpr std::size_t kFewest = 4;  ///< of a source that is slow
  static constexpr double kHeld_s = 0.5;     ///< that are enough where kBurst takes longer
  static constexpr double kPatience_s = 5.0;

  struct Taken {
    FramePtr frame;  ///< the mean, with the last one's name, time and settings
    std::size_t of = 0;
  };
  enum class State {
    kIdle = 1,
    kWaits,    ///< for ball and finger to be held still
    kRefused,  ///< they were not within kPatience_s
  };

  /// A press is wanted. Taken at once where what was seen last is held; else by see(), or by end().
  [[nodiscard]] std::optional<Taken> want(double time_s);
  /// The next frame, and the contact that it shows. time_s: of any clock that goes on. Light that
  /// flickers makes no two frames the same: there a contact that holds still is taken as it is.
  [[nodiscard]] std::optional<Taken> see(const FramePtr& frame,
                                         const std::optional<DarkPatch>& contact,
                                         double time_s);
  /// No further frame comes: the last one stands still.
  [[nodiscard]] std::optional<Taken> end();
  /// What was seen, and that anything was wanted: another finger, or nobody looks.
  void forget();

  [[nodiscard]] State state() const { return state_; }
  /// Part of a burst that is there, [0, 1].
  [[nodiscard]] double held_part() const;

 private:
  [[nodiscard]] bool is_enough() const;
  [[nodiscard]] Taken take(const std::vector<FramePtr>& frames);

  HeldFrames held_{kBurst};
  FramePtr newest_;              // null: none
  std::vector<FramePtr> alike_;  // with the newest
  State state_ = State::kIdle;
  double wanted_s_ = 0;
  StationaryContactDetector contact_;  // since then
};

}  // namespace alltact
