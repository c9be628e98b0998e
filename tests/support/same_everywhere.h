// Windows that look the same on every computer, for pictures that are kept.
#pragma once

#include <QApplication>
#include <QFont>

namespace alltact::test {

/// The same letters, and no cursor that is sometimes there.
class SameEverywhere {
 public:
  SameEverywhere() : font_(QApplication::font()), flash_(QApplication::cursorFlashTime()) {
    QFont font(QStringLiteral("DejaVu Sans"), 9);
    font.setHintingPreference(QFont::PreferNoHinting);
    QApplication::setFont(font);
    QApplication::setCursorFlashTime(0);
  }
  ~SameEverywhere() {
    QApplication::setFont(font_);
    QApplication::setCursorFlashTime(flash_);
  }
  SameEverywhere(const SameEverywhere&) = delete;
  SameEverywhere& operator=(const SameEverywhere&) = delete;

 private:
  QFont font_;
  int flash_;
};

}  // namespace alltact::test
