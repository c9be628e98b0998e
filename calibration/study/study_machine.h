// What a study's times depend on besides the program: the computer and its power supply.
#pragma once

#include "core/base/job.h"
#include "core/base/message.h"

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include <malloc.h>
#include <nlohmann/json_fwd.hpp>

namespace alltact {

struct StudyMachine {
  std::string processor = "unknown";  ///< as its maker names it
  int cores = 0;                      ///< that this program may use
  std::string system;                 ///< kernel and release
  std::string governor = "unknown";   ///< of the first core's clock: "performance"; see cpufreq
  std::optional<double> clock_mhz;    ///< of the first core, at that time
  std::optional<bool> is_on_battery;  ///< empty: the computer does not report it
};

/// Of this computer, now. Values that cannot be read stay unknown.
///   root: "/"; another in tests
[[nodiscard]] StudyMachine this_machine(const std::filesystem::path& root = "/");

[[nodiscard]] nlohmann::json json_of(const StudyMachine& machine);

/// Processor seconds of this thread, without the load of other programs.
[[nodiscard]] double thread_cpu_s();

// Remaining time of a study, from its progress.

class StudyClock {
 public:
  /// Reports the progress of the study with the remaining time, after two seconds and 2 % of the
  /// work.
  void report(const Job& job, double fraction, const Message& what) const {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
    job.report(fraction, with_time_left(fraction, spent.count(), what));
  }
  [[nodiscard]] static Message with_time_left(double fraction, double spent_s,
                                              const Message& what) {
    if (fraction < 0.02 || fraction > 1 || spent_s < 2) return what;
    const double left_s = spent_s * (1 - fraction) / fraction;
    return left_s < 90 ? en::say("{}, {:.0f} s left", what, left_s)
                       : en::say("{}, {:.0f} min left", what, left_s / 60);
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Heap memory of the program, for studies that report memory.

/// Bytes of the heap that are allocated.
inline std::size_t heap_bytes() {
  const auto heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

}  // namespace alltact
