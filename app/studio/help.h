// The help's texts, which the help window, the first-time hints and the printed guide all read.
#pragma once

#include "app/studio/menus.h"
#include "core/base/result.h"
#include "widgets/widget_base.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QListWidget>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTextBrowser>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

/// ":/alltact/help/NAME_LANGUAGE.md" for the window's language; the English one where there is
/// none.
[[nodiscard]] QString help_file(const QString& name);
/// Its text; empty where there is no such page.
[[nodiscard]] QString help_text(const QString& name);

/// The beginning of every page's help.
struct HelpLead {
  QString title;
  QString lead;       ///< the first paragraph, in one line
  QString image;      ///< a file next to the page; empty: none
  QStringList steps;  ///< the numbered list, each entry in one line
};
[[nodiscard]] HelpLead lead_of(const QString& markdown);

/// The text of a Markdown paragraph for a label, without its marks.
[[nodiscard]] QString without_marks(QString markdown);

// The help in a window of its own: a list of pages and the chosen page.

class Page;

class HelpWindow : public Translated<QDialog> {
  Q_OBJECT
 public:
  HelpWindow(const std::vector<Page*>& pages, QWidget* parent);
  /// The name of a page of the window, "keys", "effects" or "glossary".
  void show_page(const QString& name);

 private:
  void name_pages();
  void load();

  std::vector<Page*> pages_;
  QListWidget* list_;  // with the page's name in Qt::UserRole
  QTextBrowser* text_;
  QDialogButtonBox* buttons_;
};

// The quick guide: two pages to print and to pin up next to the finger, made from the beginning and
// the images of the pages' help.

/// A4, in the window's language. `date` (UTC, 2026-01-31T12:00:00Z) becomes the file's creation
/// time, so that the same texts give the same bytes. GUI thread. Error: the texts do not fit on two
/// pages in readable letters.
[[nodiscard]] Result<std::string> quick_guide_pdf(const std::string& date);

// The menu Help: the help of the shown page, the keys, the glossary, a printable guide, and
// information about this program.

class HelpMenu : public TranslatedMenu {
  Q_OBJECT
 public:
  /// `page` returns the name of the shown page; `window` is the parent of the help's window.
  HelpMenu(std::function<std::string()> page, std::vector<Page*> pages, QWidget* window);
  /// Help of the shown page.
  void show_help();

 Q_SIGNALS:
  void failed(const alltact::Error& why);

 private:
  void show_page(const QString& name);
  void choose_guide_file();
  void write_guide(const QString& file);
  void show_about();

  std::function<std::string()> page_;
  std::vector<Page*> pages_;
  QPointer<HelpWindow> help_window_;
};

}  // namespace alltact
