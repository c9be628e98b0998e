#include "calibration/live/followed_finger.h"

#include <utility>

namespace alltact {
namespace {

bool measure_alike(const FingerSnapshot& a, const FingerSnapshot& b) {
  return a.revision == b.revision && a.measuring == b.measuring;
}

}  // namespace

Result<std::unique_ptr<FollowedFinger>> FollowedFinger::open(
    const std::filesystem::path& folder,
    MakePipeline make,
    const Job& job,
    std::chrono::milliseconds between_looks) {
  auto store = FingerStore::of(folder);
  const auto finger = store->snapshot();
  if (!finger) return finger.error();
  auto pipeline = make(**finger, job);
  if (!pipeline) return pipeline.error();
  return std::unique_ptr<FollowedFinger>(new FollowedFinger(
      std::move(store), std::move(make), {*finger, std::move(*pipeline)}, between_looks));
}

FollowedFinger::FollowedFinger(std::shared_ptr<FingerStore> store,
                               MakePipeline make,
                               Ready now,
                               std::chrono::milliseconds between_looks)
    : store_(std::move(store)),
      make_(std::move(make)),
      now_(std::move(now)),
      looked_at_(now_.finger),
      thread_([this, between_looks](const std::stop_token& stop) { look(stop, between_looks); }) {}

FollowedFinger::~FollowedFinger() {
  loading_.request_stop();
}

void FollowedFinger::look(const std::stop_token& stop, std::chrono::milliseconds between_looks) {
  while (!stop.stop_requested()) {
    {
      std::unique_lock lock(mutex_);
      ending_.wait_for(lock, stop, between_looks, [] { return false; });
    }
    if (!stop.stop_requested()) look_once();
  }
}

void FollowedFinger::look_once() {
  const auto finger = store_->snapshot();
  if (!finger) {
    const std::string sentence = finger.error().sentence();
    if (std::exchange(unreadable_, sentence) == sentence) return;
    const std::lock_guard lock(mutex_);
    problem_ = finger.error();
    return;
  }
  unreadable_.clear();
  if (measure_alike(**finger, *looked_at_)) return;
  looked_at_ = *finger;
  auto pipeline = make_(**finger, loading_);
  if (loading_.stop_requested()) return;
  std::optional<Ready> unused;  // freed outside the lock: it may hold a whole recording
  const std::lock_guard lock(mutex_);
  if (pipeline)
    unused = std::exchange(next_, Ready{*finger, std::move(*pipeline)});
  else
    problem_ = pipeline.error();
}

bool FollowedFinger::take_news() {
  std::optional<Ready> next;
  {
    const std::lock_guard lock(mutex_);
    next = std::exchange(next_, std::nullopt);
  }
  if (!next) return false;
  now_ = std::move(*next);
  return true;
}

std::optional<Error> FollowedFinger::take_problem() {
  const std::lock_guard lock(mutex_);
  return std::exchange(problem_, std::nullopt);
}

}  // namespace alltact
