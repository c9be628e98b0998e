// One step of a calibration.
#pragma once

#include "widgets/shell/step_list.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace alltact {

class StepPage : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit StepPage(QWidget* parent = nullptr) : Translated(parent) {}
  [[nodiscard]] virtual QString title() const = 0;
  [[nodiscard]] virtual StepState state() const = 0;
  /// What is missing before the next step can begin; empty: nothing.
  [[nodiscard]] virtual QString missing() const = 0;
  /// What a foot pedal does here, as the space bar.
  virtual void press_pedal() {}
  /// Where the way back and on stands: below the column beside the picture. Null: below the page.
  [[nodiscard]] virtual QVBoxLayout* foot() const { return nullptr; }
  /// What is most likely used next; has the focus when the step is gone to.
  [[nodiscard]] virtual QWidget* main_control() const = 0;

  /// The one thing to do here before going on; null: nothing, or nothing now.
  [[nodiscard]] virtual const QPushButton* to_do() const {
    return qobject_cast<const QPushButton*>(main_control());
  }

 Q_SIGNALS:
  /// The state, or what is missing, may have changed.
  void changed();
};

/// A label for sentences.
[[nodiscard]] inline QLabel* wrapped_text() {
  auto* label = new QLabel;
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace alltact
