// Long work that can be watched and stopped, knowing nothing of windows or terminals.
#pragma once

#include "core/message.h"

#include <atomic>
#include <functional>

namespace alltact {

/// Handed to long work by whoever waits for it. The work calls report() and asks stop_requested()
/// often; the one who waits may call request_stop() from any thread. Work that was stopped returns
/// the best result it has, or an error saying that it was stopped before it had one.
class Job {
 public:
  /// fraction in [0, 1]; what: a short phrase ("reading frame 12 of 240").
  using Listener = std::function<void(double fraction, const Message& what)>;

  Job() = default;
  explicit Job(Listener listener) : listener_(std::move(listener)) {}
  /// A stretch of `whole`, from one fraction of it to another: reports there, and stops with it.
  Job(const Job& whole, double from, double to)
      : listener_([&whole, from, to](double fraction, const Message& what) {
          whole.report(from + fraction * (to - from), what);
        }),
        whole_(&whole) {}

  void report(double fraction, const Message& what) const {
    if (listener_) listener_(fraction, what);
  }
  void request_stop() { stop_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool stop_requested() const {
    return stop_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->stop_requested());
  }

 private:
  Listener listener_;
  std::atomic<bool> stop_{false};
  const Job* whole_ = nullptr;
};

}  // namespace alltact
