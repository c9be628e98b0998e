#include "widgets/report/offscreen.h"

#include <QApplication>
#include <QLocale>
#include <cstdio>

namespace alltact {

namespace {

/// What Qt finds strange about a computer without a desktop is no concern of one who wants a page.
void say_nothing(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtFatalMsg) std::fprintf(stderr, "%s\n", qPrintable(text));
}

}  // namespace

OffscreenDrawing::OffscreenDrawing() {
  if (QCoreApplication::instance() != nullptr) return;
  qInstallMessageHandler(say_nothing);
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

OffscreenDrawing::~OffscreenDrawing() {
  if (application_) qInstallMessageHandler(nullptr);
}

}  // namespace alltact
