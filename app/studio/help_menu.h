// The menu Help: the help of the shown page, the glossary, a printable guide, and information about
// this program.
#pragma once

#include "app/studio/translated_menu.h"
#include "core/result.h"

#include <QPointer>
#include <string>
#include <vector>

namespace alltact {

class HelpWindow;
class Page;

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
