#include "core/sources/source.h"

#include "core/base/guarded.h"

#include <algorithm>

namespace alltact {
namespace {

constexpr std::chrono::milliseconds kStopPoll{50};  // interval between checks for a stop

}  // namespace

bool Pacer::wait_for(std::int64_t time_ns) {
  if (pace_ != Pace::kRecorded) return true;
  if (!begin_) {
    begin_ = Clock::now();
    first_ns_ = time_ns;
  }
  const Clock::time_point due = *begin_ + std::chrono::nanoseconds(time_ns - first_ns_);
  while (Clock::now() < due) {
    if (job_ != nullptr && job_->stop_requested()) return false;
    std::this_thread::sleep_until(std::min(due, Clock::now() + kStopPoll));
  }
  return true;
}

void wait_frame_period(double frames_per_s, const std::function<bool()>& is_stopped) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(1 / frames_per_s));
  for (auto now = Clock::now(); now < end && !is_stopped(); now = Clock::now())
    std::this_thread::sleep_for(std::min<Clock::duration>(kStopPoll, end - now));
}

NewestSource::NewestSource(std::unique_ptr<Source> source)
    : source_(std::move(source)), worker_([this](const std::stop_token& stop) { run(stop); }) {}

void NewestSource::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    auto frame = guarded([this] { return source_->next(); });
    const bool is_untimed = frame && *frame && !(*frame)->time_ns && !source_->is_live();
    if (take(std::move(frame))) return;
    if (is_untimed)
      wait_frame_period(source_->frames_per_s(), [&] { return stop.stop_requested(); });
  }
}

bool NewestSource::take(Result<FramePtr> frame) {
  constexpr std::size_t kMaxErrors = 100;  // late errors have no use
  const std::lock_guard lock(mutex_);
  if (!frame) {
    if (errors_.size() < kMaxErrors) errors_.push_back(frame.error());
  } else {
    skipped_ += newest_ && *frame ? 1 : 0;
    is_over_ = *frame == nullptr;
    if (!is_over_) newest_ = std::move(*frame);
  }
  changed_.notify_all();
  return is_over_;
}

Result<FramePtr> NewestSource::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return newest_ || !errors_.empty() || is_over_; });
  if (!errors_.empty()) {
    Error error = std::move(errors_.front());
    errors_.pop_front();
    return error;
  }
  return std::exchange(newest_, nullptr);
}

std::uint64_t NewestSource::skipped() const {
  const std::lock_guard lock(mutex_);
  return skipped_;
}

struct FrameHubState {
  std::mutex mutex;
  std::condition_variable changed;
  FramePtr latest;
  std::uint64_t published = 0;
  bool is_closed = false;
  std::vector<FrameQueue*> queues;

  void enqueue_all(const Result<FramePtr>& item) {
    for (FrameQueue* queue : queues) queue->put(item);
  }
};

FramePtr LatestFrameReader::next(std::chrono::milliseconds timeout) {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait_for(
      lock, timeout, [&] { return state_->published > seen_ || state_->is_closed || is_woken_; });
  is_woken_ = false;
  if (state_->published == seen_) return nullptr;
  missed_ += state_->published - seen_ - 1;
  seen_ = state_->published;
  return state_->latest;
}

void LatestFrameReader::wake() {
  {
    const std::lock_guard lock(state_->mutex);
    is_woken_ = true;
  }
  state_->changed.notify_all();
}

FrameQueue::~FrameQueue() {
  const std::lock_guard lock(state_->mutex);
  std::erase(state_->queues, this);
}

std::optional<Result<FramePtr>> FrameQueue::next(std::chrono::milliseconds timeout) {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait_for(lock, timeout, [&] { return !items_.empty() || state_->is_closed; });
  if (items_.empty()) {
    if (state_->is_closed) return Result<FramePtr>(FramePtr());
    return std::nullopt;
  }
  Result<FramePtr> item = std::move(items_.front());
  items_.pop_front();
  if (item.ok()) --frames_;
  return item;
}

std::uint64_t FrameQueue::dropped() const {
  const std::lock_guard lock(state_->mutex);
  return dropped_;
}

void FrameQueue::put(const Result<FramePtr>& item) {
  if (item.ok()) {
    if (frames_ == capacity_) {
      ++dropped_;
      return;
    }
    ++frames_;
  } else if (!items_.empty() && !items_.back().ok()) {
    items_.pop_back();  // one fault is enough: repeated faults must not fill the queue
  }
  items_.push_back(item);
}

FrameHub::FrameHub() : state_(std::make_shared<FrameHubState>()) {}

FrameHub::~FrameHub() { close(); }

void FrameHub::publish(FramePtr frame) {
  FramePtr before;  // released outside the lock: the last owner frees the image
  {
    const std::lock_guard lock(state_->mutex);
    state_->enqueue_all(frame);
    before = std::exchange(state_->latest, std::move(frame));
    ++state_->published;
  }
  state_->changed.notify_all();
}

void FrameHub::fault(const Error& error) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->enqueue_all(error);
  }
  state_->changed.notify_all();
}

void FrameHub::close() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->is_closed = true;
  }
  state_->changed.notify_all();
}

FramePtr FrameHub::latest() const {
  const std::lock_guard lock(state_->mutex);
  return state_->latest;
}

LatestFrameReader FrameHub::reader() const {
  const std::lock_guard lock(state_->mutex);
  return {state_, state_->published};
}

std::unique_ptr<FrameQueue> FrameHub::subscribe(std::size_t capacity) const {
  std::unique_ptr<FrameQueue> queue(new FrameQueue(state_, capacity));
  const std::lock_guard lock(state_->mutex);
  state_->queues.push_back(queue.get());
  return queue;
}

}  // namespace alltact
