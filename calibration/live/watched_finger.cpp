#include "calibration/live/watched_finger.h"

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
      worker_([this, poll_interval](const std::stop_token& stop) {
        while (!is_stopped_within(stop, poll_interval))
          if (const Status polled = guarded([this] { poll_once(); }); !polled)
            problem_.put(polled.error());
      }) {}

WatchedFinger::~WatchedFinger() { loading_.request_stop(); }

void WatchedFinger::poll_once() {
  const auto finger = store_->snapshot();
  if (!finger) {
    const std::string sentence = finger.error().sentence();
    if (std::exchange(unreadable_, sentence) != sentence) problem_.put(finger.error());
    return;
  }
  unreadable_.clear();
  if ((*finger)->revision == last_seen_->revision && (*finger)->measuring == last_seen_->measuring)
    return;
  last_seen_ = *finger;
  auto pipeline = make_(**finger, loading_);
  if (loading_.stop_requested()) return;
  if (pipeline)
    next_.put({*finger, std::move(*pipeline)});
  else
    problem_.put(pipeline.error());
}

bool WatchedFinger::take_update() {
  auto next = next_.take();
  if (!next) return false;
  now_ = std::move(*next);
  return true;
}

}  // namespace alltact
