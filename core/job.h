// Long work that can be watched and stopped, knowing nothing of windows or terminals.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <string_view>

namespace alltact {

/// How far a calculation that repeats itself until it settles has come.
struct Round {
  int number = 1;          ///< from 1; begins anew with each stretch of the calculation
  double residual_mm = 0;  ///< mean absolute, of the solution so far
  double change_mm = 0;    ///< how much the unknowns moved in this round
};

/// Handed to long work by whoever waits for it. The work calls report() and asks stop_requested()
/// often; the one who waits may call request_stop() from any thread. Work that was stopped returns
/// the best result it has, or an error saying that it was stopped before it had one.
class Job {
 public:
  /// fraction in [0, 1]; what: a short phrase ("reading frame 12 of 240").
  using Listener = std::function<void(double fraction, std::string_view what)>;

  using RoundListener = std::function<void(const Round& round)>;

  Job() = default;
  explicit Job(Listener listener, RoundListener on_round = {})
      : listener_(std::move(listener)), on_round_(std::move(on_round)) {}
  /// A stretch of `whole`, from one fraction of it to another: reports there, and stops with it.
  Job(const Job& whole, double from, double to)
      : listener_([&whole, from, to](double fraction, std::string_view what) {
          whole.report(from + fraction * (to - from), what);
        }),
        on_round_(whole.on_round_),
        whole_(&whole) {}

  void report(double fraction, std::string_view what) const {
    if (listener_) listener_(fraction, what);
  }
  /// What a round costs to tell need not be worked out where nobody listens.
  [[nodiscard]] bool hears_rounds() const { return on_round_ != nullptr; }
  void report_round(const Round& round) const {
    if (on_round_) on_round_(round);
  }
  void request_stop() { stop_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool stop_requested() const {
    return stop_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->stop_requested());
  }

 private:
  Listener listener_;
  RoundListener on_round_;
  std::atomic<bool> stop_{false};
  const Job* whole_ = nullptr;
};

}  // namespace alltact
