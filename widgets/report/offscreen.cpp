#include "widgets/report/offscreen.h"

#include <QApplication>
#include <QLocale>

namespace alltact {

OffscreenDrawing::OffscreenDrawing() {
  if (QCoreApplication::instance() != nullptr) return;
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // One size of everything, whatever the user's desktop says.
  for (const char* name : {"QT_SCALE_FACTOR", "QT_FONT_DPI", "QT_SCREEN_SCALE_FACTORS"})
    qunsetenv(name);
  QLocale::setDefault(QLocale::c());
  QApplication::setStyle("Fusion");
  static int count = 1;
  static char name[] = "alltact";
  static char* words[] = {name, nullptr};
  application_ = std::make_unique<QApplication>(count, words);
}

OffscreenDrawing::~OffscreenDrawing() = default;

}  // namespace alltact
