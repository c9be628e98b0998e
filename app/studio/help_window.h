// The help in a window of its own: the pages in a list, the chosen one beside it.
#pragma once

#include "widgets/translated.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QTextBrowser>
#include <utility>
#include <vector>

namespace alltact {

class Place;

class HelpWindow : public Translated<QDialog> {
  Q_OBJECT
 public:
  HelpWindow(const std::vector<Place*>& places, QWidget* parent);
  /// A place's, "effects" or "glossary".
  void show_page(const QString& name);

 private:
  void name_pages();
  void load();

  std::vector<Place*> places_;
  QListWidget* pages_;  // with the page's name in Qt::UserRole
  QTextBrowser* text_;
  QDialogButtonBox* buttons_;
};

}  // namespace alltact
