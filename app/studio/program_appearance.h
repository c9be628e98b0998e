// Sets the theme and the language of the full program.
#pragma once

#include "widgets/language.h"
#include "widgets/shell/settings_dialog.h"

namespace alltact {

class ProgramAppearance {
 public:
  /// Widgets follow by PaletteChange and LanguageChange.
  void apply(const Appearance& appearance);
  [[nodiscard]] const Appearance& appearance() const { return appearance_; }

 private:
  void set_language(const QString& language);

  Appearance appearance_;
  QString language_;  // empty at first: English has plural forms to load, too
  WindowTranslator app_translator_, qt_translator_;
};

}  // namespace alltact
