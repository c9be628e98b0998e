// The menu Help: the page of the place that is shown, and what this program is.
#pragma once

#include "app/studio/translated_menu.h"

#include <string>

namespace alltact {

class HelpMenu : public TranslatedMenu {
  Q_OBJECT
 public:
  /// `place` names the place that is shown; `window` has the pages' windows.
  HelpMenu(std::function<std::string()> place, QWidget* window);

 private:
  void show_help();
  void show_about();
  /// A page of text in a window of its own.
  void show_page(const QString& title, const QString& markdown, const QSize& size);

  std::function<std::string()> place_;
};

}  // namespace alltact
