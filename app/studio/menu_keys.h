// Alt and a menu's letter opens that menu everywhere. A page may have a button or a label with the
// same letter, in any language; Qt would then only move the focus from one to the other.
#pragma once

#include <QMenuBar>
#include <QObject>

namespace alltact {

class MenuKeys : public QObject {
  Q_OBJECT
 public:
  /// Listens to `window`, which has the menus.
  MenuKeys(QMenuBar& menus, QWidget& window);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] QAction* menu_of(const QKeyEvent& key) const;

  QMenuBar& menus_;
  QWidget& window_;
};

}  // namespace alltact
