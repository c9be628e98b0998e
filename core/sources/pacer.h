// Delays frames to their recorded pace.
#pragma once

#include "core/sources/source.h"

#include <chrono>
#include <functional>
#include <optional>

namespace alltact {

/// Waits until a frame is due. The first frame is due at once and starts the clock. A late caller
/// does not wait, and the frames behind it retain their times. With Pace::kOnDemand nothing waits.
/// One thread.
class Pacer {
 public:
  explicit Pacer(const SourceOptions& options) : pace_(options.pace), job_(options.job) {}

  /// time_ns: time of the frame, on any clock. False: the job was stopped during the wait.
  [[nodiscard]] bool wait_for(std::int64_t time_ns);

 private:
  using Clock = std::chrono::steady_clock;

  Pace pace_;
  const Job* job_;
  std::optional<Clock::time_point> begin_;
  std::int64_t first_ns_ = 0;
};

/// Waits one frame period, at most, for images, which have no times.
void wait_frame_period(double frames_per_s, const std::function<bool()>& is_stopped);

}  // namespace alltact
