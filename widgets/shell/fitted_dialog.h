// Base of all dialogs: texts follow the language, and no line of them is cut off.
#pragma once

#include "widgets/translated.h"

#include <QDialog>
#include <QLayout>

namespace alltact {

/// Never lower than its wrapped texts need at its width; layouts guarantee that only for
/// themselves.
class FittedDialog : public Translated<QDialog> {
 public:
  using Translated::Translated;

 protected:
  bool event(QEvent* event) override {
    const bool is_handled = Translated::event(event);
    const bool may_differ = event->type() == QEvent::LayoutRequest ||
                            event->type() == QEvent::Resize || event->type() == QEvent::Show;
    if (may_differ && layout() != nullptr && layout()->hasHeightForWidth())
      setMinimumHeight(layout()->totalHeightForWidth(width()));
    return is_handled;
  }
};

}  // namespace alltact
