#include "core/sources/frame_hub.h"

namespace alltact {

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
      lock, timeout, [&] { return state_->published > seen_ || state_->is_closed; });
  if (state_->published == seen_) return nullptr;
  missed_ += state_->published - seen_ - 1;
  seen_ = state_->published;
  return state_->latest;
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

FrameHub::~FrameHub() {
  close();
}

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
