#include "widgets/calibrating/space_key.h"

#include "widgets/shell/step_list.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace alltact {

SpaceKey::SpaceKey(QWidget& page, std::function<void()> act)
    : QObject(&page), page_(page), act_(std::move(act)) {
  qApp->installEventFilter(this);
}

bool SpaceKey::handles_space(const QWidget& widget) const {
  const QWidget* inner = &widget;
  const auto* line = qobject_cast<const QLineEdit*>(inner);
  if (line != nullptr && qobject_cast<const QAbstractSpinBox*>(line->parentWidget()) != nullptr)
    return false;
  if (line != nullptr || qobject_cast<const QTextEdit*>(inner) != nullptr ||
      qobject_cast<const QPlainTextEdit*>(inner) != nullptr ||
      qobject_cast<const QComboBox*>(inner) != nullptr ||
      qobject_cast<const QMenu*>(inner) != nullptr)
    return true;
  // Step buttons are no exception: they keep the focus after the step was opened.
  return qobject_cast<const QAbstractButton*>(inner) != nullptr && inner != clicked_ &&
         qobject_cast<const StepList*>(inner->parentWidget()) == nullptr;
}

bool SpaceKey::eventFilter(QObject* receiver, QEvent* event) {
  const auto* clicked = qobject_cast<const QWidget*>(receiver);
  if (event->type() == QEvent::MouseButtonPress && clicked != nullptr &&
      (clicked->focusPolicy() & Qt::ClickFocus) != 0)
    clicked_ = receiver;  // the focus may be there already
  if (event->type() == QEvent::FocusIn) {
    const auto reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason)
      clicked_ = reason == Qt::MouseFocusReason ? receiver : nullptr;
    return false;
  }
  if (event->type() != QEvent::KeyPress) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  const auto* widget = qobject_cast<QWidget*>(receiver);
  if (key->key() != Qt::Key_Space || key->modifiers() != Qt::NoModifier || widget == nullptr ||
      !page_.isVisible() || widget->window() != page_.window() || handles_space(*widget))
    return false;
  if (!key->isAutoRepeat()) act_();
  return true;
}

}  // namespace alltact
