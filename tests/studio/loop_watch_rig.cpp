#include "tests/studio/loop_watch_rig.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QImage>
#include <QPainter>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

/// How many times slower than the computer the limit was set on this one paints, at least 1: a slow
/// one is not the window's doing either. The best of several pictures of lines and letters.
double times_slower() {
  constexpr double kThereMs = 5.0;
  double best_ms = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 8; ++round) {
    QImage image(640, 480, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QElapsedTimer timer;
    timer.start();
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < 400; ++i) {
      painter.drawLine(QLineF(0, 1.2 * i, 640, 480 - 1.2 * i));
      painter.drawText(QPointF(1.5 * i, 480 - 1.2 * i), QStringLiteral("0.25 mm"));
    }
    painter.end();
    best_ms = std::min(best_ms, 1e-6 * static_cast<double>(timer.nsecsElapsed()));
  }
  std::printf("[ figures  ] a picture of lines and letters takes %.2f ms\n", best_ms);
  return std::max(1.0, best_ms / kThereMs);
}

}  // namespace

/// The longest time between two turns of the event loop, without the time for which the thread was
/// ready and the computer had no core for it: that is not the window's doing. Neither is what a
/// thread that only sleeps a millisecond at a time has to wait beyond that.
class Watchdog {
 public:
  Watchdog() {
    timer_.setTimerType(Qt::PreciseTimer);
    QObject::connect(&timer_, &QTimer::timeout, [this] { look(); });
    timer_.start(1);
    sleeper_ = std::jthread([this](const std::stop_token& stop) {
      for (auto last = Clock::now(); !stop.stop_requested();) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const auto now = Clock::now();
        const double gap_ms = std::chrono::duration<double, std::milli>(now - last).count();
        sleeper_longest_ms_ = std::max(sleeper_longest_ms_.load(), gap_ms);
        last = now;
      }
    });
  }
  void begin() {
    last_.reset();
    longest_ms_ = 0;
    sleeper_longest_ms_ = 0;
    look();
  }
  [[nodiscard]] double longest_ms() const { return longest_ms_; }
  [[nodiscard]] double sleeper_longest_ms() const { return sleeper_longest_ms_; }

 private:
  using Clock = std::chrono::steady_clock;
  /// The kernel's account of this thread: on a core, waiting for one (ns), turns.
  static double waited_ms() {
    double on_core = 0, waited = 0;
    std::ifstream("/proc/thread-self/schedstat") >> on_core >> waited;
    return waited * 1e-6;
  }
  void look() {
    const auto now = Clock::now();
    const double waited = waited_ms();
    if (last_) {
      const double gap_ms = std::chrono::duration<double, std::milli>(now - *last_).count();
      longest_ms_ = std::max(longest_ms_, gap_ms - (waited - last_waited_ms_));
    }
    last_ = now;
    last_waited_ms_ = waited;
  }
  QTimer timer_;
  std::optional<Clock::time_point> last_;
  double longest_ms_ = 0, last_waited_ms_ = 0;
  std::atomic<double> sleeper_longest_ms_{0};
  std::jthread sleeper_;
};

LoopWatch::LoopWatch() : limit_ms_(30 * times_slower()), watchdog_(std::make_unique<Watchdog>()) {}

LoopWatch::~LoopWatch() = default;

void LoopWatch::during(const std::string& what, const std::function<void()>& act, int wait_ms) {
  watchdog_->begin();
  QEventLoop loop;
  QTimer::singleShot(0, act);
  QTimer::singleShot(wait_ms, &loop, &QEventLoop::quit);
  loop.exec();  // QTest::qWait would sleep in between
  const double longest_ms = watchdog_->longest_ms(), sleeper_ms = watchdog_->sleeper_longest_ms();
  std::printf("[ figures  ] %-20s %5.1f ms (a sleeper %.1f ms)\n", what.c_str(), longest_ms,
              sleeper_ms);
  if (longest_ms >= limit_ms_ + sleeper_ms) too_long_ms_[what] = longest_ms;
}

void LoopWatch::expect_free(const std::function<void(LoopWatch&)>& use) {
  constexpr int kUses = 3;
  std::map<std::string, double> held_ms;
  for (int i = 0; i < kUses; ++i) {
    LoopWatch watch;
    use(watch);
    if (testing::Test::HasFatalFailure()) return;
    if (i == 0) held_ms = watch.too_long_ms_;
    for (auto one = held_ms.begin(); one != held_ms.end();) {
      const auto again = watch.too_long_ms_.find(one->first);
      one = again == watch.too_long_ms_.end() ? held_ms.erase(one) : std::next(one);
    }
    if (held_ms.empty()) return;
  }
  for (const auto& [what, longest_ms] : held_ms)
    ADD_FAILURE() << what << " held the event loop for " << longest_ms << " ms";
}

}  // namespace alltact::test
