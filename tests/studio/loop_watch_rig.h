// Whether a use of the window ever holds the event loop for longer than a person notices.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace alltact::test {

class Watchdog;

/// Measures one use of the window, action by action. What a busy or slow computer adds is no doing
/// of the window's, and comes and goes, while what the window does comes back: an action counts as
/// blocking only where it held the loop too long in each of three uses.
class LoopWatch {
 public:
  LoopWatch();
  ~LoopWatch();
  LoopWatch(const LoopWatch&) = delete;
  LoopWatch& operator=(const LoopWatch&) = delete;

  /// Does it in the event loop, which then turns for `wait_ms`.
  void during(const std::string& what, const std::function<void()>& act, int wait_ms);

  /// Fails where an action held the loop for more than 30 ms, three times.
  static void expect_free(const std::function<void(LoopWatch&)>& use);

 private:
  double limit_ms_;
  std::unique_ptr<Watchdog> watchdog_;
  std::map<std::string, double> too_long_ms_;  ///< action -> what it held the loop for
};

}  // namespace alltact::test
