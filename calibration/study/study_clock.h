// Remaining time of a study, from its progress.
#pragma once

#include "core/job.h"
#include "core/message.h"

#include <chrono>

namespace alltact {

class StudyClock {
 public:
  /// Reports the progress of the study with the remaining time, after two seconds and 2 % of the
  /// work.
  void report(const Job& job, double fraction, const Message& what) const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    job.report(fraction, with_time_left(fraction, spent.count(), what));
  }
  [[nodiscard]] static Message with_time_left(double fraction,
                                              double spent_s,
                                              const Message& what) {
    if (fraction < 0.02 || fraction > 1 || spent_s < 2) return what;
    const double left_s = spent_s * (1 - fraction) / fraction;
    return left_s < 90 ? en::say("{}, {:.0f} s left", what, left_s)
                       : en::say("{}, {:.0f} min left", what, left_s / 60);
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace alltact
