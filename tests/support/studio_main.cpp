// The Studio is tested on Qt's offscreen platform, in one style and one language, with settings of
// its own.
#include "tests/support/program.h"
#include "tests/support/qt_messages.h"
#include "tests/support/run_all_tests.h"
#include "widgets/scene3d/vtk_view.h"
#include "widgets/theme.h"

#include <QApplication>
#include <QLocale>
#include <cstdlib>
#include <memory>

int main(int argc, char** argv) {
  alltact::test::show_qt_messages();
  auto home = std::make_unique<alltact::test::TemporaryFolder>();
  setenv("QT_QPA_PLATFORM", "offscreen", 0);
  // Folders that tests share are never destroyed (see below): they go with this one.
  setenv("TMPDIR", home->path().c_str(), 1);
  setenv("XDG_CONFIG_HOME", (*home / "config").c_str(), 1);
  setenv("XDG_DATA_HOME", (*home / "data").c_str(), 1);
  setenv("XDG_RUNTIME_DIR", home->path().c_str(), 1);
  setenv("LANGUAGE", "en", 1);
  QLocale::setDefault(QLocale(QLocale::English));
  QApplication::setStyle(new alltact::StudioStyle);
  alltact::VtkView::prepare_application();
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName("alltact");
  QCoreApplication::setApplicationName("alltact-studio-tests");
  const int status = alltact::test::run_all_tests(argc, argv);
  home.reset();
  return status;
}
