#include "core/base/worker.h"

#include <list>

namespace alltact {
namespace {

struct Left {
  std::future<void> ended;
  std::jthread thread;
};

struct LeftWorkers {
  std::mutex mutex;
  std::list<Left> all;

  void drop_ended() {
    all.remove_if([](const Left& one) {
      return one.ended.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    });
  }
};

/// Never destroyed: a thread that hangs in a driver may outlive everything else.
LeftWorkers& left_workers() {
  static auto* const workers = new LeftWorkers;
  return *workers;
}

}  // namespace

void Worker::join() {
  if (thread_.joinable()) thread_.join();
}

void Worker::end_later() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  LeftWorkers& left = left_workers();
  const std::lock_guard lock(left.mutex);
  left.drop_ended();
  left.all.push_back({std::move(ended_), std::move(thread_)});
}

bool finish_workers(std::chrono::milliseconds timeout) {
  const auto end = std::chrono::steady_clock::now() + timeout;
  LeftWorkers& left = left_workers();
  while (true) {
    std::list<Left> waiting;
    {
      const std::lock_guard lock(left.mutex);
      waiting.swap(left.all);
    }
    // Ending work may leave work of its own: it is waited for in the next round.
    if (waiting.empty()) return true;
    bool is_late = false;
    for (Left& one : waiting)
      is_late = one.ended.wait_until(end) != std::future_status::ready || is_late;
    if (!is_late) continue;
    const std::lock_guard lock(left.mutex);
    left.all.splice(left.all.end(), waiting);
    left.drop_ended();
    return false;
  }
}

bool is_stopped_within(const std::stop_token& stop, std::chrono::milliseconds duration) {
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  return never.wait_for(lock, stop, duration, [&] { return stop.stop_requested(); });
}

}  // namespace alltact
