// The menu Help: the page of the place that is shown, the glossary, a guide to print, and what this
// program is.
#pragma once

#include "app/studio/translated_menu.h"
#include "core/result.h"

#include <QPointer>
#include <string>
#include <vector>

namespace alltact {

class HelpWindow;
class Place;

class HelpMenu : public TranslatedMenu {
  Q_OBJECT
 public:
  /// `place` names the place that is shown; `window` has the pages' windows.
  HelpMenu(std::function<std::string()> place, std::vector<Place*> places, QWidget* window);
  /// Of the place that is shown.
  void show_help();

 Q_SIGNALS:
  void failed(const alltact::Error& why);

 private:
  void show_page(const QString& name);
  void choose_guide_file();
  void write_guide(const QString& file);
  void show_about();

  std::function<std::string()> place_;
  std::vector<Place*> places_;
  QPointer<HelpWindow> pages_;
};

}  // namespace alltact
