#include "widgets/inspect/inspection.h"

#include "widgets/inspect/inspector.h"

#include <QMetaObject>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace alltact {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kQuiet = std::chrono::milliseconds(700);

}  // namespace

/// The worker and the window meet here.
struct Inspection::Shared {
  std::mutex mutex;
  std::condition_variable news;
  InspectWish wish;
  bool is_wished = false, is_working = false, looks_further = false, is_at_end = false;
  Clock::time_point last_wish_at;
  std::optional<InspectAnswer> answer;
  std::optional<Inspector::News> summaries;
  std::shared_ptr<Job> job = std::make_shared<Job>();  // of the work that goes on
  std::jthread thread;

  /// Changes the wish and wakes the worker.
  void ask(const std::function<void(InspectWish&)>& change, bool is_enough) {
    const std::lock_guard lock(mutex);
    change(wish);
    is_wished = (is_wished || is_enough) && (wish.live != nullptr || !wish.input.empty());
    is_at_end = false;
    news.notify_one();
  }
  /// With the lock held.
  [[nodiscard]] bool may_look_further() const {
    return looks_further && !is_at_end && !wish.live && !wish.input.empty();
  }
  /// Until something is to be done. Wishes that follow each other, as of a recording that plays,
  /// are not interrupted: what lasts over frames would be forgotten.
  void wait(std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
    const auto is_enough = [&] { return stop.stop_requested() || is_wished; };
    if (may_look_further() && news.wait_until(lock, last_wish_at + kQuiet, is_enough)) return;
    if (!may_look_further()) news.wait(lock, [&] { return is_enough() || may_look_further(); });
  }
  /// With the lock held.
  [[nodiscard]] bool is_due() const {
    return may_look_further() && Clock::now() >= last_wish_at + kQuiet;
  }
  /// With the lock held; true where the window is to be told.
  bool add(Inspector::News more) {
    if (more.summaries.empty() && !more.is_from_scratch) return false;
    const bool is_told = summaries.has_value();
    if (!summaries || more.is_from_scratch) {
      more.is_from_scratch = more.is_from_scratch || (summaries && summaries->is_from_scratch);
      summaries = std::move(more);
    } else {
      summaries->summaries.insert(
          summaries->summaries.end(), more.summaries.begin(), more.summaries.end());
    }
    return !is_told;
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
      shared->wait(lock, stop);
      if (stop.stop_requested()) return;
      const InspectWish wish = shared->wish;
      const auto job = shared->job;
      const bool is_wished = std::exchange(shared->is_wished, false);
      if (!is_wished && !shared->is_due()) continue;
      shared->is_working = is_wished;
      lock.unlock();
      std::optional<InspectAnswer> answer;
      const bool goes_on = is_wished || inspector.look_further(*job);
      if (is_wished) answer = inspector(wish, *job);
      Inspector::News news = inspector.news();
      lock.lock();
      shared->is_working = false;
      if (is_wished) shared->last_wish_at = Clock::now();
      shared->is_at_end = !goes_on;  // a wish may have brought another recording
      if (shared->add(std::move(news)))
        QMetaObject::invokeMethod(this, &Inspection::take_summaries, Qt::QueuedConnection);
      if (!answer) continue;
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

void Inspection::set_other(const Comparand& other) {
  if (shared_->wish.other == other) return;
  shared_->ask([&](InspectWish& wish) { wish.other = other; }, true);
}

void Inspection::set_looking_further(bool is_on) {
  const std::lock_guard lock(shared_->mutex);
  shared_->looks_further = is_on;
  shared_->news.notify_one();
}

void Inspection::open(const std::filesystem::path& input, std::size_t number) {
  recording_.reset();
  frame_.reset();
  problem_.reset();
  summaries_.clear();
  shared_->ask(
      [&](InspectWish& wish) {
        wish.input = input;
        wish.number = number;
        wish.live.reset();
      },
      true);
  Q_EMIT state_changed();
  Q_EMIT summaries_changed();
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

void Inspection::take_summaries() {
  Inspector::News news;
  {
    const std::lock_guard lock(shared_->mutex);
    if (!shared_->summaries) return;
    news = std::move(*shared_->summaries);
    shared_->summaries.reset();
  }
  if (news.is_from_scratch) summaries_.clear();
  summaries_.insert(summaries_.end(), news.summaries.begin(), news.summaries.end());
  Q_EMIT summaries_changed();
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
