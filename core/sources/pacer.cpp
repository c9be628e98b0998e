#include "core/sources/pacer.h"

#include <thread>

namespace alltact {
namespace {

constexpr std::chrono::milliseconds kStopPoll{50};  // interval between checks for a stop

}  // namespace

bool Pacer::wait_for(std::int64_t time_ns) {
  if (pace_ != Pace::kRecorded) return true;
  if (!begin_) {
    begin_ = Clock::now();
    first_ns_ = time_ns;
  }
  const Clock::time_point due = *begin_ + std::chrono::nanoseconds(time_ns - first_ns_);
  while (Clock::now() < due) {
    if (job_ != nullptr && job_->stop_requested()) return false;
    std::this_thread::sleep_until(std::min(due, Clock::now() + kStopPoll));
  }
  return true;
}

void wait_frame_period(double frames_per_s, const std::function<bool()>& is_stopped) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(1 / frames_per_s));
  for (auto now = Clock::now(); now < end && !is_stopped(); now = Clock::now())
    std::this_thread::sleep_for(std::min<Clock::duration>(kStopPoll, end - now));
}

}  // namespace alltact
