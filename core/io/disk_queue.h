// Writes that must not be waited for and must not be lost.
#pragma once

#include "core/result.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace alltact {

/// Any thread may call any function.
class DiskQueue {
 public:
  using Task = std::function<Status()>;

  DiskQueue();
  ~DiskQueue();  ///< does all that waits first
  DiskQueue(const DiskQueue&) = delete;
  DiskQueue& operator=(const DiskQueue&) = delete;

  /// Done one after the other, at once, on a thread of its own.
  void add(Task task);
  /// Until nothing waits any more.
  void wait();
  /// Why the latest task that failed did, until one succeeds.
  [[nodiscard]] std::optional<Error> problem() const;
  /// What was written for matters no more.
  void forget_problem();

 private:
  void work(const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::condition_variable_any news_;
  std::deque<Task> tasks_;
  bool is_busy_ = false;
  std::optional<Error> problem_;
  std::jthread thread_;
};

}  // namespace alltact
