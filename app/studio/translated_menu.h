// A menu whose title and entries follow the language.
#pragma once

#include "widgets/translated.h"

#include <QMenu>
#include <utility>

namespace alltact {

class TranslatedMenu : public Translated<QMenu> {
 public:
  using Words = std::function<QString()>;

  explicit TranslatedMenu(QWidget* parent) : Translated(parent) {}

  void set_title(Words title) {
    say([this, title = std::move(title)] { setTitle(title()); });
  }
  /// An entry at the menu's end; `keys` may be empty.
  QAction* add(const QList<QKeySequence>& keys, Words words, const std::function<void()>& act) {
    QAction* entry = addAction(QString());
    entry->setShortcuts(keys);
    connect(entry, &QAction::triggered, this, act);
    say([entry, words = std::move(words)] { entry->setText(words()); });
    return entry;
  }
};

}  // namespace alltact
