#include "app/studio/menu_keys.h"

#include <QApplication>
#include <QKeyEvent>

namespace alltact {

MenuKeys::MenuKeys(QMenuBar& menus, QWidget& window)
    : QObject(&window), menus_(menus), window_(window) {
  qApp->installEventFilter(this);
}

QAction* MenuKeys::menu_of(const QKeyEvent& key) const {
  if (key.modifiers() != Qt::AltModifier) return nullptr;
  for (QAction* menu : menus_.actions())
    if (menu->isEnabled() &&
        QKeySequence::mnemonic(menu->text()) == QKeySequence(Qt::ALT | Qt::Key(key.key())))
      return menu;
  return nullptr;
}

bool MenuKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (widget == nullptr || widget->window() != &window_) return false;
  QAction* menu = menu_of(static_cast<const QKeyEvent&>(*event));
  if (menu == nullptr) return false;
  // An accepted key reaches no shortcut any more.
  event->accept();
  if (event->type() == QEvent::KeyPress) menus_.setActiveAction(menu);
  return true;
}

}  // namespace alltact
