// Puts theme and language on the whole program.
#pragma once

#include "widgets/language.h"
#include "widgets/shell/settings_dialog.h"

namespace alltact {

class Dresser {
 public:
  /// Widgets follow by PaletteChange and LanguageChange.
  void wear(const Appearance& appearance);
  [[nodiscard]] const Appearance& appearance() const { return appearance_; }

 private:
  void speak(const QString& language);

  Appearance appearance_;
  QString spoken_;  // nothing at first: English has plurals to load, too
  WindowTranslator ours_, qt_;
};

}  // namespace alltact
