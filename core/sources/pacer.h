// Letting frames come as they came when they were taken.
#pragma once

#include "core/sources/source.h"

#include <chrono>
#include <functional>
#include <optional>

namespace alltact {

/// Waits until a frame is due. The first one is due at once and begins the count; whoever comes
/// late is not made to wait, and the frames behind it keep their times. With Pace::kAsked nothing
/// waits. Used by one thread.
class Pacer {
 public:
  explicit Pacer(const SourceOptions& options) : pace_(options.pace), job_(options.job) {}

  /// time_ns: of the frame, on any clock. False: the job was stopped while it waited.
  [[nodiscard]] bool wait_for(std::int64_t time_ns);

 private:
  using Clock = std::chrono::steady_clock;

  Pace pace_;
  const Job* job_;
  std::optional<Clock::time_point> begin_;
  std::int64_t first_ns_ = 0;
};

/// Pictures have no times: they come as often as a camera's would.
void wait_between_pictures(double frames_per_s, const std::function<bool()>& is_stopped);

}  // namespace alltact
