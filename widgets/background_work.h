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
  void stop();
  [[nodiscard]] bool is_running() const { return shared_ != nullptr; }
  [[nodiscard]] double fraction() const { return fraction_; }
  [[nodiscard]] const Message& what() const { return what_; }
  /// Empty as long as it cannot be told.
  [[nodiscard]] std::optional<double> seconds_left() const;

 Q_SIGNALS:
  void progressed();
  void finished();

 private:
  struct Shared;
  void look();

  std::shared_ptr<Shared> shared_;
  QTimer timer_;
  QElapsedTimer since_;
  double fraction_ = 0;
  Message what_;
};

}  // namespace alltact
