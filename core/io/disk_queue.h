// Background writes that must not be lost.
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
  ~DiskQueue();  ///< finishes all tasks first
  DiskQueue(const DiskQueue&) = delete;
  DiskQueue& operator=(const DiskQueue&) = delete;

  /// Runs tasks one after the other on a thread of its own.
  void add(Task task);
  /// Waits until all tasks are done.
  void wait();
  /// The error of the latest failed task, until one succeeds.
  [[nodiscard]] std::optional<Error> problem() const;
  /// Discards the error, when its file is no longer relevant.
  void clear_problem();

 private:
  void work(const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Task> tasks_;
  bool is_busy_ = false;
  std::optional<Error> problem_;
  std::jthread thread_;
};

}  // namespace alltact
