#include "app/studio/command_search.h"

#include "app/studio/help.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace alltact {
namespace {

QString keys_of(const QAction& action) {
  QStringList keys;
  for (const QKeySequence& sequence : action.shortcuts())
    keys << sequence.toString(QKeySequence::NativeText);
  return keys.join(QStringLiteral(", "));
}

}  // namespace

CommandSearch::CommandSearch(QMainWindow& window)
    : FittedDialog(&window), window_(window), words_(new QLineEdit), list_(new RowList) {
  auto* column = new QVBoxLayout(this);
  add_widgets(*column, {words_, list_});
  list_->setColumnCount(3);
  words_->installEventFilter(this);
  words_->setClearButtonEnabled(true);
  connect(words_, &QLineEdit::textChanged, this, &CommandSearch::fill);
  connect(words_, &QLineEdit::returnPressed, this, &CommandSearch::run);
  connect(list_, &QTreeWidget::itemActivated, this, &CommandSearch::run);
  resize(560, 420);
  say([this] {
    setWindowTitle(tr("Find a command"));
    words_->setPlaceholderText(tr("Words of the command"));
    words_->setAccessibleName(tr("Words of the command"));
    words_->setToolTip(tr("Any words of the command, in any order; Enter runs the marked one"));
    list_->setAccessibleName(tr("Commands"));
    list_->setHeaderLabels({tr("Command"), tr("Menu or page"), tr("Keys")});
    // Once the menus have the new language as well.
    QTimer::singleShot(0, this, [this] {
      collect();
      fill();
    });
  });
  collect();
  fill();
  words_->setFocus();
}

void CommandSearch::collect() {
  commands_.clear();
  for (const QAction* action : window_.menuBar()->actions())
    if (action->menu() != nullptr)
      collect(*action->menu(), without_mnemonic(action->menu()->title()));
  for (QAbstractButton* button : window_.centralWidget()->findChildren<QAbstractButton*>()) {
    const bool is_command =
        qobject_cast<QPushButton*>(button) != nullptr || qobject_cast<QToolButton*>(button);
    const QString name = without_mnemonic(button->text()).simplified();
    if (!is_command || !button->isVisible() || !button->isEnabled() || name.isEmpty()) continue;
    commands_.push_back({name, tr("this page"),
                         button->shortcut().toString(QKeySequence::NativeText), nullptr, button});
  }
  collect_view_keys();
}

/// The rows of the page's tables, each table under its heading.
void CommandSearch::collect_view_keys() {
  QString view;
  bool is_head = true;
  for (const QString& line : help_text(QStringLiteral("keys")).split(QLatin1Char('\n'))) {
    const QStringList cells = line.split(QLatin1Char('|'));
    if (line.startsWith(QLatin1String("## "))) {
      view = line.mid(3).trimmed();
      is_head = true;
    } else if (cells.size() == 4) {
      const QString keys = cells[1].trimmed(), does = cells[2].trimmed();
      if (!is_head) commands_.push_back({does, view, keys, nullptr, nullptr});
      if (keys.startsWith(QLatin1String("---"))) is_head = false;
    }
  }
}

void CommandSearch::collect(const QMenu& menu, const QString& group) {
  for (QAction* action : menu.actions()) {
    if (action->isSeparator() || !action->isVisible() || !action->isEnabled()) continue;
    if (action->menu() != nullptr) {
      collect(*action->menu(), group);
      continue;
    }
    const QString name = without_mnemonic(action->text());
    if (!name.isEmpty()) commands_.push_back({name, group, keys_of(*action), action, nullptr});
  }
}

void CommandSearch::fill() {
  const QStringList words = words_->text().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  list_->clear();
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    const Command& command = commands_[i];
    const QString text = command.name + QLatin1Char(' ') + command.group;
    const bool is_match = std::all_of(words.begin(), words.end(), [&](const QString& word) {
      return text.contains(word, Qt::CaseInsensitive);
    });
    if (!is_match) continue;
    auto* row = new QTreeWidgetItem(list_, {command.name, command.group, command.keys});
    row->setData(0, Qt::UserRole, static_cast<qulonglong>(i));
  }
  list_->fit_columns();
  if (list_->topLevelItemCount() > 0) list_->setCurrentItem(list_->topLevelItem(0));
}

void CommandSearch::run() {
  const QTreeWidgetItem* chosen = list_->currentItem();
  if (chosen == nullptr) return;
  const Command command = commands_[chosen->data(0, Qt::UserRole).toULongLong()];
  accept();
  // After this dialog, which some commands would find open.
  QTimer::singleShot(0, &window_, [command] {
    if (command.action != nullptr && command.action->isEnabled()) command.action->trigger();
    if (command.button != nullptr && command.button->isEnabled()) command.button->click();
  });
}

bool CommandSearch::eventFilter(QObject* watched, QEvent* event) {
  if (watched == words_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Down || key == Qt::Key_Up || key == Qt::Key_PageDown ||
        key == Qt::Key_PageUp) {
      QCoreApplication::sendEvent(list_, event);
      return true;
    }
  }
  return FittedDialog::eventFilter(watched, event);
}

}  // namespace alltact
