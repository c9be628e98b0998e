#include "widgets/inspect/inspection.h"

#include "widgets/inspect/inspector.h"

#include <QMetaObject>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace alltact {

/// The worker and the window meet here.
struct Inspection::Shared {
  std::mutex mutex;
  std::condition_variable news;
  InspectWish wish;
  bool is_wished = false, is_working = false;
  std::optional<InspectAnswer> answer;
  std::shared_ptr<Job> job = std::make_shared<Job>();  // of the work that goes on
  std::jthread thread;

  /// Changes the wish and wakes the worker.
  void ask(const std::function<void(InspectWish&)>& change, bool is_enough) {
    const std::lock_guard lock(mutex);
    change(wish);
    is_wished = (is_wished || is_enough) && (wish.live != nullptr || !wish.input.empty());
    news.notify_one();
  }
};

Inspection::Inspection(QObject* parent) : QObject(parent), shared_(std::make_shared<Shared>()) {
  Shared* shared = shared_.get();
  shared->thread = std::jthread([this, shared](const std::stop_token& stop) {
    Inspector inspector;
    const std::stop_callback wake(stop, [shared] {
      const std::lock_guard lock(shared->mutex);
      shared->job->request_stop();
      shared->news.notify_one();
    });
    std::unique_lock lock(shared->mutex);
    while (!stop.stop_requested()) {
      shared->news.wait(lock, [&] { return stop.stop_requested() || shared->is_wished; });
      if (stop.stop_requested()) return;
      const InspectWish wish = shared->wish;
      const auto job = shared->job;
      shared->is_wished = false;
      shared->is_working = true;
      lock.unlock();
      InspectAnswer answer = inspector(wish, *job);
      lock.lock();
      shared->is_working = false;
      const bool is_told = shared->answer.has_value();
      shared->answer = std::move(answer);
      if (!is_told) QMetaObject::invokeMethod(this, &Inspection::take, Qt::QueuedConnection);
    }
  });
}

Inspection::~Inspection() {
  shared_->thread.request_stop();
  shared_->thread.join();
}

void Inspection::set_finger(const std::filesystem::path& folder) {
  if (shared_->wish.finger == folder) return;
  shared_->ask([&](InspectWish& wish) { wish.finger = folder; }, !shared_->wish.input.empty());
}

void Inspection::set_other(OtherMethod other) {
  shared_->ask([&](InspectWish& wish) { wish.other = other; }, true);
}

void Inspection::open(const std::filesystem::path& input, std::size_t number) {
  recording_.reset();
  frame_.reset();
  problem_.reset();
  shared_->ask(
      [&](InspectWish& wish) {
        wish.input = input;
        wish.number = number;
        wish.live.reset();
      },
      true);
  Q_EMIT state_changed();
}

void Inspection::show_frame(std::size_t number) {
  shared_->ask([&](InspectWish& wish) { wish.number = number; }, true);
}

void Inspection::measure_again() {
  if (!shared_->wish.input.empty()) shared_->ask([](InspectWish&) {}, true);
}

void Inspection::show_live(std::shared_ptr<const LiveView> view, const Finger& finger) {
  shared_->ask(
      [&](InspectWish& wish) {
        wish.live = std::move(view);
        wish.live_finger = finger;
      },
      true);
}

bool Inspection::is_busy() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->is_wished || shared_->is_working;
}

void Inspection::take() {
  InspectAnswer answer;
  {
    const std::lock_guard lock(shared_->mutex);
    if (!shared_->answer) return;
    answer = std::move(*shared_->answer);
    shared_->answer.reset();
    // Of a recording that has been closed since, or of the live finger.
    if (answer.recording && answer.recording->input != shared_->wish.input) return;
    if (!answer.recording && !answer.problem && !shared_->wish.live) return;
  }
  recording_ = answer.recording;
  problem_ = answer.problem;
  if (answer.frame || problem_) {  // what was shown before is of another frame, or another finger
    frame_ = answer.frame;
    Q_EMIT frame_ready();
  }
  Q_EMIT state_changed();
}

}  // namespace alltact
