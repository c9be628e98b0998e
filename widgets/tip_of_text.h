// A path or a command may be longer than its field.
#pragma once

#include <QLineEdit>

namespace alltact {

/// From now on the field's tip is its text, whole.
inline void show_text_as_tip(QLineEdit& field) {
  QObject::connect(&field, &QLineEdit::textChanged, &field, &QWidget::setToolTip);
}

}  // namespace alltact
