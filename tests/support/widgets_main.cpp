// Widgets are tested on Qt's offscreen platform, in one style and one language, wherever they run.
#include "tests/support/qt_messages.h"
#include "tests/support/run_all_tests.h"

#include <QApplication>
#include <QLocale>

int main(int argc, char** argv) {
  alltact::test::show_qt_messages();
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  QLocale::setDefault(QLocale::c());
  QApplication::setStyle("Fusion");
  QApplication application(argc, argv);
  return alltact::test::run_all_tests(argc, argv);
}
