#include "widgets/report/offscreen.h"

#include "widgets/report/document.h"

#include <QApplication>
#include <QBuffer>
#include <QHashFunctions>
#include <QImage>
#include <QLocale>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QSemaphore>
#include <QSvgRenderer>
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
  const Error none{en::say("there is not enough memory to draw"), "",
                   en::say("close other programs")};
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

namespace {

constexpr int kSharpness = 2;
constexpr double kPointsPerPixel = 72.0 / 96;

QByteArray figure_png(QSvgRenderer& figure) {
  QImage image(figure.defaultSize() * kSharpness, QImage::Format_RGB32);
  image.fill(Qt::white);
  {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    figure.render(&painter);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes;
}

QByteArray figure_pdf(QSvgRenderer& figure, const QString& title) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter writer(&buffer);
  writer.setTitle(title);
  writer.setCreator("AllTact Studio");
  writer.setResolution(300);
  writer.setPageLayout(
      QPageLayout(QPageSize(QSizeF(figure.defaultSize()) * kPointsPerPixel, QPageSize::Point),
                  QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
  QPainter painter(&writer);
  figure.render(&painter);
  painter.end();
  return bytes;
}

}  // namespace

Result<SvgFigureFiles> svg_figure_files(const std::string& svg, const std::string& title,
                                        const std::string& date) {
  QSvgRenderer figure(QByteArray::fromStdString(svg));
  if (!figure.isValid()) return Error{en::say("the figure cannot be drawn"), "", ""};
  // Qt writes fonts in the order of a hash, which otherwise differs from run to run.
  QHashSeed::setDeterministicGlobalSeed();
  const QByteArray png = figure_png(figure);
  QByteArray pdf = figure_pdf(figure, QString::fromStdString(title));
  QHashSeed::resetRandomGlobalSeed();
  if (png.isEmpty() || pdf.isEmpty()) return Error{en::say("the figure cannot be drawn"), "", ""};
  set_pdf_time(pdf, date);
  return SvgFigureFiles{png.toStdString(), pdf.toStdString()};
}

}  // namespace alltact
