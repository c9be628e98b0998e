#include "calibration/live/watched_finger.h"

#include "core/base/guarded.h"

#include <utility>

namespace alltact {

Result<std::unique_ptr<WatchedFinger>> WatchedFinger::open(
    const std::filesystem::path& folder, MakePipeline make, const Job& job,
    std::chrono::milliseconds poll_interval) {
  auto store = FingerStore::of(folder);
  const auto finger = store->snapshot();
  if (!finger) return finger.error();
  auto pipeline = make(**finger, job);
  if (!pipeline) return pipeline.error();
  return std::unique_ptr<WatchedFinger>(new WatchedFinger(
      std::move(store), std::move(make), {*finger, std::move(*pipeline)}, poll_interval));
}

WatchedFinger::WatchedFinger(std::shared_ptr<FingerStore> store, MakePipeline make, Ready now,
                             std::chrono::milliseconds poll_interval)
    : store_(std::move(store)),
      make_(std::move(make)),
      now_(std::move(now)),
      last_seen_(now_.finger),
      thread_([this, poll_interval](const std::stop_token& stop) { poll(stop, poll_interval); }) {}

WatchedFinger::~WatchedFinger() { loading_.request_stop(); }

void WatchedFinger::poll(const std::stop_token& stop, std::chrono::milliseconds poll_interval) {
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      ending_.wait_for(lock, stop, poll_interval, [] { return false; });
    }
    if (stop.stop_requested()) return;
    if (const Status polled = guarded([this] { poll_once(); }); !polled) {
      const std::lock_guard lock(mutex_);
      problem_ = polled.error();
    }
  }
}

void WatchedFinger::poll_once() {
  const auto finger = store_->snapshot();
  if (!finger) {
    const std::string sentence = finger.error().sentence();
    if (std::exchange(unreadable_, sentence) == sentence) return;
    const std::lock_guard lock(mutex_);
    problem_ = finger.error();
    return;
  }
  unreadable_.clear();
  if ((*finger)->revision == last_seen_->revision && (*finger)->measuring == last_seen_->measuring)
    return;
  last_seen_ = *finger;
  auto pipeline = make_(**finger, loading_);
  if (loading_.stop_requested()) return;
  std::optional<Ready> unused;  // freed outside the lock: it may hold a full recording
  const std::lock_guard lock(mutex_);
  if (pipeline)
    unused = std::exchange(next_, Ready{*finger, std::move(*pipeline)});
  else
    problem_ = pipeline.error();
}

bool WatchedFinger::take_update() {
  std::optional<Ready> next;
  {
    const std::lock_guard lock(mutex_);
    next = std::exchange(next_, std::nullopt);
  }
  if (!next) return false;
  now_ = std::move(*next);
  return true;
}

std::optional<Error> WatchedFinger::take_problem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, std::nullopt);
}

}  // namespace alltact
