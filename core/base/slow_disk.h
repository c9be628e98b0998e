// Reports a disk that does not answer, such as a stalled network disk. A busy processor is no slow
// disk: only time counts in which a thread neither runs nor queues for a processor.
#pragma once

#include "core/base/result.h"
#include "core/base/worker.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace alltact {

/// Marks its thread as waiting for a file while it lives; an inner one belongs to the outer one.
/// Use it around system calls, not around work of other threads: sleep counts as waiting. The cost
/// is negligible without a DiskWatch.
class DiskWait {
 public:
  explicit DiskWait(const std::filesystem::path& file);
  DiskWait(const DiskWait&) = delete;
  DiskWait& operator=(const DiskWait&) = delete;
  ~DiskWait();
};

/// Watches all DiskWaits of the program while it lives; one at a time.
class DiskWatch {
 public:
  /// `on_slow` is called on a thread of its own when a wait was blocked for longer than `timeout`,
  /// at most 1.25 times that after its begin. It is called once for each disk and stall. `file` is
  /// final_path() of the file.
  DiskWatch(std::chrono::milliseconds timeout,
            std::function<void(const std::filesystem::path& file)> on_slow);
  DiskWatch(const DiskWatch&) = delete;
  DiskWatch& operator=(const DiskWatch&) = delete;
  ~DiskWatch();
  /// final_path() of each file whose wait is blocked for longer than `timeout`, longest first.
  [[nodiscard]] std::vector<std::filesystem::path> slow() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Time of a disk's answer after which it is reported to a person.
inline constexpr std::chrono::seconds kDiskTimeout{3};

/// Minimum time of answers before a disk is reported again.
inline constexpr std::chrono::minutes kDiskQuiet{10};

/// The message for a slow file.
[[nodiscard]] Error slow_disk(const std::filesystem::path& file);

// Background writes that must not be lost.

/// Any thread may call any function.
class DiskQueue {
 public:
  using Task = std::function<Status()>;

  DiskQueue();
  ~DiskQueue() = default;  ///< finishes all tasks first
  DiskQueue(const DiskQueue&) = delete;
  DiskQueue& operator=(const DiskQueue&) = delete;

  /// Runs tasks one after the other on a thread of its own. `file`: what the task writes.
  void add(std::filesystem::path file, Task task);
  /// Waits until all tasks are done.
  void wait();
  /// The error of the latest failed task, until a later one succeeds in writing the same file.
  [[nodiscard]] std::optional<Error> problem() const;
  /// Discards all errors, when their files are no longer relevant.
  void clear_problem();

 private:
  void work(const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  struct Waiting {
    std::filesystem::path file;
    Task task;
  };
  struct Failed {
    std::filesystem::path file;
    Error error;
  };
  std::deque<Waiting> tasks_;
  bool is_busy_ = false;
  std::vector<Failed> problems_;  // latest last
  Worker worker_;                 // last: it ends first
};

}  // namespace alltact
