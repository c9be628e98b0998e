#include "widgets/report/svg_figure.h"

#include "widgets/report/pdf_date.h"

#include <QBuffer>
#include <QHashFunctions>
#include <QImage>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>

namespace alltact {
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
                  QPageLayout::Portrait,
                  QMarginsF(0, 0, 0, 0)));
  QPainter painter(&writer);
  figure.render(&painter);
  painter.end();
  return bytes;
}

}  // namespace

Result<SvgFigureFiles> svg_figure_files(const std::string& svg,
                                        const std::string& title,
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
