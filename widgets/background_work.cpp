#include "widgets/background_work.h"

#include "core/base/guarded.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <thread>
#include <utility>

namespace alltact {

namespace {

constexpr int kBetweenLooks_ms = 50;

}  // namespace

UnexpectedErrors& UnexpectedErrors::instance() {
  static UnexpectedErrors errors;
  return errors;
}

UnexpectedErrors::UnexpectedErrors() { moveToThread(QCoreApplication::instance()->thread()); }

void UnexpectedErrors::report(const Error& error) {
  QMetaObject::invokeMethod(
      this, [this, error] { Q_EMIT reported(error); }, Qt::QueuedConnection);
}

struct BackgroundWork::Shared {
  std::mutex mutex;
  double fraction = 0;
  Message what;
  bool is_done = false;
  std::function<void()> at_end;
  bool is_replaced = false;  // both only on the window's thread
  Job job{[this](double part, const Message& words) {
    const std::lock_guard lock(mutex);
    fraction = part;
    what = words;
  }};
};

BackgroundWork::BackgroundWork(QObject* parent) : QObject(parent) {
  connect(&timer_, &QTimer::timeout, this, &BackgroundWork::look);
}

BackgroundWork::~BackgroundWork() { stop(); }

void BackgroundWork::start(Work work) {
  if (shared_) return;
  shared_ = std::make_shared<Shared>();
  fraction_ = 0;
  what_ = {};
  since_.start();
  timer_.start(kBetweenLooks_ms);
  std::thread([shared = shared_, work = std::move(work)] {
    std::function<void()> at_end;
    if (const Status ran = guarded([&] { at_end = work(shared->job); }); !ran)
      UnexpectedErrors::instance().report(ran.error());
    const std::lock_guard lock(shared->mutex);
    shared->at_end = std::move(at_end);
    shared->is_done = true;
  }).detach();
}

void BackgroundWork::restart(Work work) {
  if (!shared_) return start(std::move(work));
  shared_->job.request_stop();
  shared_->is_replaced = true;
  waiting_ = std::move(work);
}

void BackgroundWork::stop() {
  waiting_ = nullptr;
  if (shared_) shared_->job.request_stop();
}

std::optional<double> BackgroundWork::seconds_left() const {
  constexpr double kMinFraction = 0.05;
  if (!shared_ || fraction_ < kMinFraction) return std::nullopt;
  return static_cast<double>(since_.elapsed()) * 1e-3 * (1 - fraction_) / fraction_;
}

void BackgroundWork::look() {
  std::function<void()> at_end;
  bool is_done = false;
  {
    const std::lock_guard lock(shared_->mutex);
    fraction_ = shared_->fraction;
    what_ = shared_->what;
    is_done = shared_->is_done;
    at_end = std::move(shared_->at_end);
  }
  if (!is_done) return Q_EMIT progressed();
  timer_.stop();
  const bool is_replaced = std::exchange(shared_, nullptr)->is_replaced;
  if (waiting_)
    start(std::exchange(waiting_, nullptr));
  else if (at_end && !is_replaced)
    at_end();  // which may start further work
  if (!shared_) Q_EMIT finished();
}

}  // namespace alltact
