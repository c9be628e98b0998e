// Base class of the pages of a calibration, one a step.
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
  /// What must be done before the next step; empty: nothing.
  [[nodiscard]] virtual QString missing() const = 0;
  /// Called by a foot pedal; same action as the space bar.
  virtual void press_pedal() {}
  /// Column for the buttons Undo and Next, next to the image. Null: they are below the page.
  [[nodiscard]] virtual QVBoxLayout* foot() const { return nullptr; }
  /// Most likely used control; gets the focus when the step is opened.
  [[nodiscard]] virtual QWidget* main_control() const = 0;

  /// Button of the next action on this page; null: none, or none now.
  [[nodiscard]] virtual const QPushButton* action_button() const {
    return qobject_cast<const QPushButton*>(main_control());
  }

 Q_SIGNALS:
  /// state() or missing() may have changed.
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
