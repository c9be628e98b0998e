// Long work beside the window, with progress and a stop.
#pragma once

#include "core/job.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace alltact {

/// One piece of work at a time.
class BackgroundWork : public QObject {
  Q_OBJECT
 public:
  /// Runs on a thread of its own; what it returns is called on this object's thread when it is
  /// done, and never once this object has gone.
  using Work = std::function<std::function<void()>(const Job& job)>;

  explicit BackgroundWork(QObject* parent = nullptr);
  /// Asks the work to stop; it is not waited for, so it must own all it uses.
  ~BackgroundWork() override;

  /// Does nothing while other work runs.
  void start(Work work);
  /// In place of what runs: that is asked to stop, what it returns is not called, and this runs
  /// when it has ended. Of several that wait only the last one runs. For readings of what may have
  /// changed since the one before began.
  void restart(Work work);
  /// Asks what runs to stop, whose outcome is called; what waits does not run any more.
  void stop();
  [[nodiscard]] bool is_running() const { return shared_ != nullptr; }
  [[nodiscard]] double fraction() const { return fraction_; }
  [[nodiscard]] const Message& what() const { return what_; }
  /// Empty as long as it cannot be told.
  [[nodiscard]] std::optional<double> seconds_left() const;

 Q_SIGNALS:
  void progressed();
  /// Nothing runs and nothing waits.
  void finished();

 private:
  struct Shared;
  void look();

  std::shared_ptr<Shared> shared_;
  Work waiting_;
  QTimer timer_;
  QElapsedTimer since_;
  double fraction_ = 0;
  Message what_;
};

}  // namespace alltact
