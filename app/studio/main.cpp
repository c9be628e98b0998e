// `alltact-studio`: the desktop program.
#include "app/console/parse.h"
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
#include <QSocketNotifier>
#include <QStandardPaths>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>

#include <fcntl.h>
#include <malloc.h>
#include <opencv2/core/utils/logger.hpp>
#include <unistd.h>

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
    alltact::parse(program, argc, argv);
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

int end_without_display() {
  std::cerr << "There is no display to open a window on. Try: the command line, alltact --help.\n";
  return 1;
}

/// While Qt looks for the display: where there is none it would abort, with advice to install it
/// again.
void on_message_before_display(QtMsgType type, const QMessageLogContext& /*where*/,
                               const QString& /*text*/) {
  if (type == QtFatalMsg) std::_Exit(end_without_display());
}

/// Closes the window when the desktop's session ends or somebody ends the program, so that nothing
/// is lost.
class EndOnSignal {
 public:
  explicit EndOnSignal(alltact::MainWindow& window) {
    if (::pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;
    write_end = ends_[1];
    notifier_.emplace(ends_[0], QSocketNotifier::Read);
    QObject::connect(&*notifier_, &QSocketNotifier::activated, &window,
                     [&window] { window.end(); });
    struct sigaction action {};
    action.sa_handler = [](int) {
      const char byte = 0;
      [[maybe_unused]] const auto written = ::write(write_end, &byte, 1);
    };
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::sigaction(signal, &action, nullptr);
  }
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;
  ~EndOnSignal() {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) std::signal(signal, SIG_IGN);
    for (const int end : ends_)
      if (end >= 0) ::close(end);
  }

 private:
  static inline int write_end = -1;
  std::array<int, 2> ends_{-1, -1};
  std::optional<QSocketNotifier> notifier_;
};

}  // namespace

int main(int argc, char** argv) try {
  using namespace alltact;
  StudioArguments requested;
  if (const auto status = read_arguments(argc, argv, requested)) return *status;
  sort_files(requested);
  if (!has_display()) return end_without_display();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its writing
  mallopt(M_ARENA_MAX, 2);        // threads with an arena each would hold memory that others lack
  // Decoders' own messages would mix with this program's sentences.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  cv::setNumThreads(1);  // capture, sensing and painting have a thread each already
  VtkView::prepare_application();
  int only_name = 1;
  const auto default_messages = qInstallMessageHandler(on_message_before_display);
  GuardedApplication application(only_name, argv);
  qInstallMessageHandler(default_messages);
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
  options.work_folder =
      QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation).toStdString() +
      "/AllTact";
  int status = 0;
  {
    const DiskWatch disks(kDiskTimeout, [](const std::filesystem::path&) {});
    options.slow_files = [&disks] { return disks.slow(); };
    MainWindow window(options, program_appearance);
    const EndOnSignal end_on_signal(window);
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
