#include "core/sources/newest_source.h"

#include "core/sources/pacer.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace alltact {

namespace {

constexpr std::size_t kMaxErrors = 100;  // late errors have no use

}  // namespace

struct NewestSource::State {
  std::unique_ptr<Source> source;
  mutable std::mutex mutex;
  std::condition_variable changed;
  std::deque<Error> errors;
  FramePtr newest;
  std::uint64_t skipped = 0;
  bool is_over = false;
  std::jthread thread;

  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      auto frame = source->next();
      const bool is_untimed = frame && *frame && (*frame)->time_ns == 0 && !source->is_live();
      if (take(std::move(frame))) return;
      if (is_untimed)
        wait_frame_period(source->frames_per_s(), [&] { return stop.stop_requested(); });
    }
  }

  /// True: nothing will follow.
  bool take(Result<FramePtr> frame) {
    const std::lock_guard lock(mutex);
    if (!frame) {
      if (errors.size() < kMaxErrors) errors.push_back(frame.error());
    } else {
      skipped += newest && *frame ? 1 : 0;
      is_over = *frame == nullptr;
      if (!is_over) newest = std::move(*frame);
    }
    changed.notify_all();
    return is_over;
  }
};

NewestSource::NewestSource(std::unique_ptr<Source> source) : state_(std::make_unique<State>()) {
  state_->source = std::move(source);
  state_->thread = std::jthread([s = state_.get()](const std::stop_token& stop) { s->run(stop); });
}

NewestSource::~NewestSource() = default;

Result<FramePtr> NewestSource::next() {
  State& s = *state_;
  std::unique_lock lock(s.mutex);
  s.changed.wait(lock, [&] { return s.newest || !s.errors.empty() || s.is_over; });
  if (!s.errors.empty()) {
    Error error = std::move(s.errors.front());
    s.errors.pop_front();
    return error;
  }
  return std::exchange(s.newest, nullptr);
}

std::optional<std::size_t> NewestSource::count() const {
  return std::nullopt;
}
bool NewestSource::is_continuous() const {
  return state_->source->is_continuous();
}
double NewestSource::frames_per_s() const {
  return state_->source->frames_per_s();
}
std::uint64_t NewestSource::skipped() const {
  const std::lock_guard lock(state_->mutex);
  return state_->skipped;
}

}  // namespace alltact
