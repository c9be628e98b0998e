// Finds a command by its words: all entries of the menus and all buttons of the shown page, with
// their keys, and the keys of the views, which the help's page of keys names. With an empty search
// it is the list of all shortcuts.
#pragma once

#include "widgets/controls/row_list.h"
#include "widgets/widget_base.h"

#include <QAbstractButton>
#include <QAction>
#include <QLineEdit>
#include <QMainWindow>
#include <QPointer>
#include <vector>

namespace alltact {

class CommandSearch : public FittedDialog {
  Q_OBJECT
 public:
  explicit CommandSearch(QMainWindow& window);

 protected:
  /// Arrows move in the list while the text has the focus.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Command {
    QString name, group, keys;
    QPointer<QAction> action;  ///< null: a button, or a key of a view
    QPointer<QAbstractButton> button;
  };
  void collect();
  void collect(const QMenu& menu, const QString& group);
  void collect_view_keys();
  void fill();
  void run();

  QMainWindow& window_;
  std::vector<Command> commands_;
  QLineEdit* words_;
  RowList* list_;
};

}  // namespace alltact
