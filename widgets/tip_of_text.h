// Tool tips for fields whose path or command may be longer than the field.
#pragma once

#include <QLineEdit>

namespace alltact {

/// The field's tool tip is its full text from now on.
inline void show_text_as_tip(QLineEdit& field) {
  QObject::connect(&field, &QLineEdit::textChanged, &field, &QWidget::setToolTip);
}

}  // namespace alltact
