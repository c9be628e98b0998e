// Long work on a background thread, with progress and cancellation.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/worker.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

namespace alltact {

/// Receives what report_unexpected() reports on any thread; the main window shows it. Lives on the
/// thread of the window.
class UnexpectedErrors : public QObject {
  Q_OBJECT
 public:
  [[nodiscard]] static UnexpectedErrors& instance();
  ~UnexpectedErrors() override;

 Q_SIGNALS:
  void reported(const alltact::Error& error);

 private:
  UnexpectedErrors();
};

/// Runs one piece of work at a time. What the work throws goes to report_unexpected(), and
/// nothing is called afterwards.
class BackgroundWork : public QObject {
  Q_OBJECT
 public:
  /// Runs on a thread of its own. The function that it returns is called on this object's thread
  /// afterwards, but never once this object is destroyed.
  using Work = std::function<std::function<void()>(const Job& job)>;

  explicit BackgroundWork(QObject* parent = nullptr);
  /// Requests the work to stop without waiting for it (Worker::end_later()); the work must own all
  /// that it uses.
  ~BackgroundWork() override;

  /// Does nothing while other work runs.
  void start(Work work);
  /// Replaces the running work: requests it to stop, drops its result, and runs `work` when it has
  /// ended. Of several that wait only the last one runs. Use it for readings of what may have
  /// changed since the one before began.
  void restart(Work work);
  /// Requests the running work to stop; its result is still used. Waiting work does not run any
  /// more.
  void stop();
  [[nodiscard]] bool is_running() const { return shared_ != nullptr; }
  [[nodiscard]] double fraction() const { return fraction_; }
  [[nodiscard]] const Message& what() const { return what_; }
  /// nullopt as long as it cannot be estimated.
  [[nodiscard]] std::optional<double> seconds_left() const;

 Q_SIGNALS:
  void progressed();
  /// Nothing runs and nothing waits.
  void finished();

 private:
  struct Shared;
  void look();

  std::shared_ptr<Shared> shared_;
  Worker worker_;
  Work waiting_;
  QTimer timer_;
  QElapsedTimer since_;
  double fraction_ = 0, first_fraction_ = 0;
  Message what_;
};

}  // namespace alltact
