// Threads, and the values that they hand to each other.
#pragma once

#include "core/base/guarded.h"

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

namespace alltact {

/// A thread with one piece of work. What the work throws goes to report_unexpected(). One thread
/// uses it. A system without room for another thread throws std::system_error.
class Worker {
 public:
  Worker() = default;
  /// Begins `work` at once. It is called with a std::stop_token where it accepts one. It is
  /// destroyed on its thread.
  template <class Work>
  explicit Worker(Work work) {
    std::promise<void> end;
    ended_ = end.get_future();
    thread_ = std::jthread(
        [work = std::move(work), end = std::move(end)](const std::stop_token& stop) mutable {
          {
            Work running = std::move(work);
            const Status ran = guarded([&] {
              if constexpr (std::is_invocable_v<Work&, const std::stop_token&>)
                running(stop);
              else
                running();
            });
            if (!ran) report_unexpected(ran.error());
          }
          end.set_value();
        });
  }
  Worker(Worker&&) = default;
  Worker& operator=(Worker&&) = default;  ///< ends the former work as the destructor does
  /// Requests the work to stop, and waits for its end.
  ~Worker() = default;

  /// Begun, and join() was not called yet.
  [[nodiscard]] bool is_begun() const { return thread_.joinable(); }
  void request_stop() { thread_.request_stop(); }
  /// Waits for the end of the work.
  void join();
  /// Requests the work to stop without waiting: it may be inside a slow driver or disk.
  /// finish_workers() waits for it. The work must own all that it uses.
  void end_later();

 private:
  std::future<void> ended_;
  std::jthread thread_;
};

/// Waits for all work that was left with Worker::end_later(). False: some still runs after
/// `timeout`.
[[nodiscard]] bool finish_workers(std::chrono::milliseconds timeout);

/// Waits for `duration`. True: a stop was requested, which ends the wait.
[[nodiscard]] bool is_stopped_within(const std::stop_token& stop,
                                     std::chrono::milliseconds duration);

/// Hands the newest value from one thread to another. Any thread may call any function.
template <class Value>
class Mailbox {
 public:
  /// Returns the value that it replaces; nullopt: the mailbox was empty.
  std::optional<Value> put(Value value) {
    std::optional<Value> replaced(std::move(value));
    {
      const std::lock_guard lock(mutex_);
      std::swap(value_, replaced);
    }
    filled_.notify_all();
    return replaced;
  }
  /// Calls `change` with the value, or with nullopt; nobody can take it meanwhile. True: the
  /// mailbox was empty and is filled now.
  template <class Change>
  bool change(const Change& change) {
    bool is_filled = false;
    {
      const std::lock_guard lock(mutex_);
      const bool was_empty = !value_;
      change(value_);
      is_filled = was_empty && value_;
    }
    if (is_filled) filled_.notify_all();
    return is_filled;
  }
  /// Empties it.
  std::optional<Value> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }
  /// Waits for a value and takes it; nullopt: a stop was requested and there is none.
  std::optional<Value> wait(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    filled_.wait(lock, stop, [this] { return value_.has_value(); });
    return std::exchange(value_, std::nullopt);
  }
  [[nodiscard]] bool is_empty() const {
    const std::lock_guard lock(mutex_);
    return !value_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable_any filled_;
  std::optional<Value> value_;
};

}  // namespace alltact
