#include "core/io/disk_queue.h"

namespace alltact {

DiskQueue::DiskQueue() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

DiskQueue::~DiskQueue() {
  thread_.request_stop();
  thread_.join();
}

void DiskQueue::add(Task task) {
  const std::lock_guard lock(mutex_);
  tasks_.push_back(std::move(task));
  changed_.notify_all();
}

void DiskQueue::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return tasks_.empty() && !is_busy_; });
}

std::optional<Error> DiskQueue::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

void DiskQueue::clear_problem() {
  const std::lock_guard lock(mutex_);
  problem_.reset();
}

void DiskQueue::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, stop, [this] { return !tasks_.empty(); });
    if (tasks_.empty()) return;
    const Task task = std::move(tasks_.front());
    tasks_.pop_front();
    is_busy_ = true;
    lock.unlock();
    const Status status = task();
    lock.lock();
    is_busy_ = false;
    problem_ = status ? std::nullopt : std::optional(status.error());
    changed_.notify_all();
  }
}

}  // namespace alltact
