// A foot pedal or button: learnt once, then reported with each press.
#pragma once

#include "core/sources/hid/hid_button.h"
#include "widgets/background_work.h"
#include "widgets/live/hid_ports.h"

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

namespace alltact {

/// Belongs to the window's thread; finds, learns and reads devices on background threads.
class Pedal : public QObject {
  Q_OBJECT
 public:
  explicit Pedal(HidPorts ports = {}, QObject* parent = nullptr);
  ~Pedal() override;

  /// Listens to it from now on, also after it was unplugged and plugged in again; none: to none.
  void listen(const std::optional<LearntButton>& button);
  [[nodiscard]] const std::optional<LearntButton>& button() const { return button_; }
  /// Why presses are not heard; none while it works or no pedal is chosen.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  /// Waits for a pedal that is pressed twice and listens to it; without one, to the former pedal.
  /// Does nothing while it learns.
  void learn();
  void stop_learning();
  [[nodiscard]] bool is_learning() const { return learning_.is_running(); }
  /// Next instruction, or why nothing was learnt; may be empty.
  [[nodiscard]] const QString& learning_text() const { return learning_text_; }

 Q_SIGNALS:
  void pressed();
  /// button(), problem(), is_learning() or learning_text() changed.
  void changed();

 private:
  struct Shared;
  void check_status();
  void end_learning(const Result<LearntButton>& learnt, const std::optional<LearntButton>& before);

  HidPorts ports_;
  std::optional<LearntButton> button_;
  std::optional<Error> problem_;
  std::shared_ptr<Shared> shared_;
  QTimer timer_;
  BackgroundWork learning_;
  QString learning_text_;
};

}  // namespace alltact
