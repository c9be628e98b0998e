// Long work with progress reports and cancellation, independent of windows and terminals.
#pragma once

#include "core/base/message.h"

#include <atomic>
#include <functional>

namespace alltact {

/// The caller hands it to long work. The work calls report() and asks stop_requested() often; the
/// caller may call request_stop() from any thread. Stopped work returns its best result so far, or
/// an error that it was stopped before it had one.
class Job {
 public:
  /// fraction in [0, 1]; what: a short phrase ("reading frame 12 of 240").
  using Listener = std::function<void(double fraction, const Message& what)>;

  Job() = default;
  explicit Job(Listener listener) : listener_(std::move(listener)) {}
  /// A section of `parent` between two of its fractions: reports there, and stops with it.
  Job(const Job& parent, double from, double to)
      : listener_([&parent, from, to](double fraction, const Message& what) {
          parent.report(from + fraction * (to - from), what);
        }),
        parent_(&parent) {}

  void report(double fraction, const Message& what) const {
    if (listener_) listener_(fraction, what);
  }
  void request_stop() { stop_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool stop_requested() const {
    return stop_.load(std::memory_order_relaxed) ||
           (parent_ != nullptr && parent_->stop_requested());
  }

 private:
  Listener listener_;
  std::atomic<bool> stop_{false};
  const Job* parent_ = nullptr;
};

}  // namespace alltact
