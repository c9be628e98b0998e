#include "widgets/report/offscreen.h"

#include <QApplication>
#include <QLocale>
#include <QSemaphore>
#include <QThreadPool>
#include <cstdio>
#include <system_error>
#include <thread>

#include <sys/mman.h>

namespace alltact {

namespace {

/// Drops Qt's warnings about a computer without a desktop, which do not concern a report.
void discard_messages(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type == QtFatalMsg) std::fprintf(stderr, "%s\n", qPrintable(text));
}

/// Qt and libpng end the program where memory is missing. So drawing needs about twice the memory
/// that pages of a report were seen to take.
bool has_room_to_draw() {
  constexpr std::size_t kBytes = std::size_t{256} << 20;
  void* room = ::mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (room == MAP_FAILED) return false;
  ::munmap(room, kBytes);
  return true;
}

}  // namespace

OffscreenDrawing::OffscreenDrawing() : has_room_(has_room_to_draw()) {
  if (!has_room_ || QCoreApplication::instance() != nullptr) return;
  qInstallMessageHandler(discard_messages);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // The same size everywhere, whatever the user's desktop settings.
  for (const char* name : {"QT_SCALE_FACTOR", "QT_FONT_DPI", "QT_SCREEN_SCALE_FACTORS"})
    qunsetenv(name);
  QLocale::setDefault(QLocale::c());
  QApplication::setStyle("Fusion");
  static int count = 1;
  static char name[] = "alltact";
  static char* words[] = {name, nullptr};
  application_ = std::make_unique<QApplication>(count, words);
}

Status OffscreenDrawing::ready() const {
  constexpr int kTimeout_ms = 2000;
  const Error none{
      en::say("there is not enough memory to draw"), "", en::say("close other programs")};
  if (!has_room_) return none;
  try {
    std::thread([] {}).join();  // Qt's own pool would wait for ever for a thread that cannot begin
  } catch (const std::system_error&) {
    return none;
  }
  // Painting large images on several threads waits for all of them. A thread that runs already, and
  // stays, does all the work.
  QThreadPool& pool = *QThreadPool::globalInstance();
  pool.setMaxThreadCount(1);
  pool.setExpiryTimeout(-1);
  const auto begun = std::make_shared<QSemaphore>();
  pool.start([begun] { begun->release(); });
  return begun->tryAcquire(1, kTimeout_ms) ? Status() : Status(none);
}

OffscreenDrawing::~OffscreenDrawing() {
  if (application_) qInstallMessageHandler(nullptr);
}

}  // namespace alltact
