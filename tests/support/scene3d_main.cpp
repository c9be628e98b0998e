// 3D views are tested on whatever platform QT_QPA_PLATFORM names; a screen without a person is
// xvfb-run's.
#include "tests/support/qt_messages.h"
#include "tests/support/run_all_tests.h"
#include "widgets/scene3d/vtk_view.h"

#include <QApplication>
#include <QLocale>

int main(int argc, char** argv) {
  alltact::test::show_qt_messages();
  if (qEnvironmentVariableIsEmpty("ALLTACT_UNSHARED_CONTEXTS"))
    alltact::VtkView::prepare_application();
  QLocale::setDefault(QLocale::c());
  QApplication::setStyle("Fusion");
  QApplication application(argc, argv);
  return alltact::test::run_all_tests(argc, argv);
}
