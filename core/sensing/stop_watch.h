// How long the steps of a frame take.
#pragma once

#include <chrono>

namespace alltact {

/// Writes the time since the last lap into a field of StepTimes.
class StopWatch {
 public:
  void lap(double& milliseconds) {
    const auto now = Clock::now();
    milliseconds = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
  }
  void total(double& milliseconds) const {
    milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace alltact
