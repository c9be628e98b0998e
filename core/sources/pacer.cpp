#include "core/sources/pacer.h"

#include <thread>

namespace alltact {

bool Pacer::wait_for(std::int64_t time_ns) {
  if (pace_ != Pace::kRecorded) return true;
  if (!begin_) {
    begin_ = Clock::now();
    first_ns_ = time_ns;
  }
  const Clock::time_point due = *begin_ + std::chrono::nanoseconds(time_ns - first_ns_);
  constexpr std::chrono::milliseconds kPatience{50};  // until a stop is noticed
  while (Clock::now() < due) {
    if (job_ != nullptr && job_->stop_requested()) return false;
    std::this_thread::sleep_until(std::min(due, Clock::now() + kPatience));
  }
  return true;
}

}  // namespace alltact
