// `alltact-studio`: the desktop program.
#include "app/console/studio_arguments.h"
#include "app/studio/main_window.h"
#include "core/base/program.h"
#include "core/base/slow_disk.h"
#include "core/base/worker.h"
#include "core/finger/finger.h"
#include "widgets/background_work.h"
#include "widgets/scene3d/vtk_view.h"
#include "widgets/theme.h"

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include <malloc.h>
#include <opencv2/core/utils/logger.hpp>

namespace {

constexpr std::chrono::seconds kEndTimeout{10};

/// What a slot throws is shown, and the window goes on. Qt itself lets nothing thrown pass.
class GuardedApplication : public QApplication {
 public:
  using QApplication::QApplication;
  bool notify(QObject* receiver, QEvent* event) override {
    bool is_handled = false;
    const alltact::Status ran =
        alltact::guarded([&] { is_handled = QApplication::notify(receiver, event); });
    if (!ran) alltact::report_unexpected(ran.error());
    return is_handled;
  }
};

/// Exit status when there is nothing more to do; wrong usage is reported in one line.
std::optional<int> read_arguments(int argc, char** argv, alltact::StudioArguments& requested) {
  CLI::App program;
  alltact::describe_studio(program, requested, alltact::program_version());
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error, std::cout, std::cerr) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

/// A file from a file manager: finger.yaml stands for its folder, anything else for a source of
/// frames.
void sort_files(alltact::StudioArguments& requested) {
  const std::filesystem::path named = requested.finger;
  std::error_code failed;
  if (!std::filesystem::is_regular_file(named, failed)) return;
  const bool is_finger = named.filename() == alltact::Finger::kFileName;
  const auto folder = named.has_parent_path() ? named.parent_path() : std::filesystem::path(".");
  if (!is_finger && requested.source.empty()) requested.source = requested.finger;
  requested.finger = is_finger ? folder.string() : std::string();
}

bool has_display() {
  if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) return true;
  return !qgetenv("DISPLAY").isEmpty() || !qgetenv("WAYLAND_DISPLAY").isEmpty();
}

}  // namespace

int main(int argc, char** argv) try {
  using namespace alltact;
  StudioArguments requested;
  if (const auto status = read_arguments(argc, argv, requested)) return *status;
  sort_files(requested);
  if (!has_display()) {
    std::cerr
        << "There is no display to open a window on. Try: the command line, alltact --help.\n";
    return 1;
  }
  mallopt(M_ARENA_MAX, 2);  // threads with an arena each would hold memory that others lack
  // Decoders' own messages would mix with this program's sentences.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::setNumThreads(1);  // capture, sensing and painting have a thread each already
  VtkView::prepare_application();
  int only_name = 1;
  GuardedApplication application(only_name, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("alltact"));
  QCoreApplication::setApplicationName(QStringLiteral("alltact-studio"));
  QGuiApplication::setDesktopFileName(QStringLiteral("alltact-studio"));
  QApplication::setStyle(new StudioStyle);
  ProgramAppearance program_appearance;
  {
    const QSettings settings;
    const int theme = settings.value(QStringLiteral("appearance/theme"), 1).toInt();
    program_appearance.apply({theme >= 1 && theme <= 4 ? static_cast<Theme>(theme) : Theme::kSystem,
                              settings.value(QStringLiteral("appearance/language")).toString()});
  }
  StudioOptions options;
  options.finger = requested.finger;
  if (!requested.source.empty()) options.source = {requested.source};
  options.session_folder =
      QStandardPaths::writableLocation(QStandardPaths::AppDataLocation).toStdString();
  int status = 0;
  {
    const DiskWatch disks(kDiskTimeout, [](const std::filesystem::path&) {});
    options.slow_files = [&disks] { return disks.slow(); };
    MainWindow window(options, program_appearance);
    window.show();
    status = QApplication::exec();
  }
  // The window has gone; a slow disk may still need a moment for the end of a recording. Threads
  // that hang in a driver must not meet objects that are being destroyed.
  if (!finish_workers(kEndTimeout)) std::_Exit(status);
  return status;
} catch (...) {
  alltact::report_unexpected(alltact::caught_error());
  return 1;
}
