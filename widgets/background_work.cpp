#include "widgets/background_work.h"

#include "core/base/worker.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <algorithm>
#include <utility>

namespace alltact {

namespace {

constexpr int kBetweenLooks_ms = 50;

}  // namespace

UnexpectedErrors& UnexpectedErrors::instance() {
  static UnexpectedErrors errors;
  return errors;
}

UnexpectedErrors::UnexpectedErrors() {
  moveToThread(QCoreApplication::instance()->thread());
  set_unexpected_receiver([this](const Error& error) {
    QMetaObject::invokeMethod(
        this, [this, error] { Q_EMIT reported(error); }, Qt::QueuedConnection);
  });
}

UnexpectedErrors::~UnexpectedErrors() { set_unexpected_receiver(nullptr); }

struct BackgroundWork::Shared {
  struct Progress {
    double fraction;
    Message what;
  };
  Mailbox<Progress> progress;
  Mailbox<std::function<void()>> at_end;
  bool is_replaced = false;  // of the window's thread
  Job job{[this](double fraction, const Message& what) { progress.put({fraction, what}); }};
};

BackgroundWork::BackgroundWork(QObject* parent) : QObject(parent) {
  connect(&timer_, &QTimer::timeout, this, &BackgroundWork::look);
}

BackgroundWork::~BackgroundWork() {
  stop();
  worker_.end_later();
}

void BackgroundWork::start(Work work) {
  if (shared_) return;
  shared_ = std::make_shared<Shared>();
  fraction_ = first_fraction_ = 0;
  what_ = {};
  since_.start();
  timer_.start(kBetweenLooks_ms);
  worker_.end_later();  // it may still free what its work held
  worker_ = Worker([shared = shared_, work = std::move(work)] {
    std::function<void()> at_end;
    if (const Status ran = guarded([&] { at_end = work(shared->job); }); !ran)
      report_unexpected(ran.error());
    shared->at_end.put(std::move(at_end));
  });
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
  const double done = fraction_ - first_fraction_;
  if (!shared_ || done < kMinFraction) return std::nullopt;
  return static_cast<double>(since_.elapsed()) * 1e-3 * (1 - fraction_) / done;
}

void BackgroundWork::look() {
  const auto at_end = shared_->at_end.take();
  if (auto progress = shared_->progress.take()) {
    if (fraction_ == 0 && progress->fraction > 0) {  // before, it waited for something
      since_.start();
      first_fraction_ = progress->fraction;
    }
    fraction_ = std::max(fraction_, progress->fraction);  // a bar never goes back
    what_ = std::move(progress->what);
  }
  if (!at_end) return Q_EMIT progressed();
  timer_.stop();
  const bool is_replaced = std::exchange(shared_, nullptr)->is_replaced;
  if (waiting_)
    start(std::exchange(waiting_, nullptr));
  else if (*at_end && !is_replaced)
    (*at_end)();  // which may start further work
  if (!shared_) Q_EMIT finished();
}

}  // namespace alltact
