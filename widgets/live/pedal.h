// A foot pedal or button for the window: learnt once, heard wherever a press does something.
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

/// An object of the window's thread; devices are looked for, learnt from and read beside it.
class Pedal : public QObject {
  Q_OBJECT
 public:
  explicit Pedal(HidPorts ports = {}, QObject* parent = nullptr);
  ~Pedal() override;

  /// Listens to it from now on, also when it is unplugged and comes back; none: to none.
  void listen(const std::optional<LearntButton>& button);
  [[nodiscard]] const std::optional<LearntButton>& button() const { return button_; }
  /// Why presses are not heard now; none while all is well or no pedal is chosen.
  [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  /// Waits for a pedal that is pressed twice and listens to it; where none is, to the one before.
  /// Does nothing while it learns.
  void learn();
  void stop_learning();
  [[nodiscard]] bool is_learning() const { return learning_.is_running(); }
  /// What to do now, or why nothing was learnt; empty when there is nothing to say.
  [[nodiscard]] const QString& learning_text() const { return learning_text_; }

 Q_SIGNALS:
  void pressed();
  /// button(), problem(), is_learning() or learning_text() changed.
  void changed();

 private:
  struct Shared;
  void look();
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
