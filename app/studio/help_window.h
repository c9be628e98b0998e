// The help in a window of its own: a list of pages and the chosen page.
#pragma once

#include "widgets/translated.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QTextBrowser>
#include <utility>
#include <vector>

namespace alltact {

class Page;

class HelpWindow : public Translated<QDialog> {
  Q_OBJECT
 public:
  HelpWindow(const std::vector<Page*>& pages, QWidget* parent);
  /// The name of a page of the window, "effects" or "glossary".
  void show_page(const QString& name);

 private:
  void name_pages();
  void load();

  std::vector<Page*> pages_;
  QListWidget* list_;  // with the page's name in Qt::UserRole
  QTextBrowser* text_;
  QDialogButtonBox* buttons_;
};

}  // namespace alltact
