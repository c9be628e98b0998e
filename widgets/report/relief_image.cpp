#include "widgets/report/relief_image.h"

#include "core/io/colour_map.h"
#include "widgets/report/report_words.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kGap = 8, kLine = 18;  // px at 96 to the inch
constexpr double kLength_mm = 5;        // shown next to the scales

QImage coloured(const cv::Mat_<float>& map_mm, const ColourScale& scale) {
  QImage image(map_mm.cols, map_mm.rows, QImage::Format_RGB32);
  for (int v = 0; v < map_mm.rows; ++v)
    for (int u = 0; u < map_mm.cols; ++u) {
      const double mm = static_cast<double>(map_mm(v, u));
      if (!std::isfinite(mm)) {
        image.setPixel(u, v, qRgb(128, 128, 128));
        continue;
      }
      const MapColour c = scale.colour((mm - scale.low_mm) / (scale.top_mm - scale.low_mm));
      image.setPixel(u, v, qRgb(c.red, c.green, c.blue));
    }
  return image;
}

void draw_map(QPainter& painter,
              const ExperimentMap& map,
              const ColourScale& scale,
              const QRectF& room) {
  painter.setPen(Qt::black);
  painter.drawText(QRectF(room.left(), room.top(), room.width(), kLine),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   sentence(map.name).chopped(1));
  const QRectF map_box = room.adjusted(0, kLine, 0, 0);
  painter.drawImage(map_box, coloured(map.mm, scale));
  painter.setPen(QPen(QColor("#4c5158"), 1));
  painter.drawRect(map_box);
}

/// Returns the position of the next one.
double draw_scale(QPainter& painter,
                  const ColourScale& scale,
                  const QString& title,
                  const QRectF& room) {
  constexpr double kHeight = 12, kSide = 14;  // half a number sticks out at either end
  painter.setPen(Qt::black);
  painter.drawText(QRectF(room.left(), room.top(), room.width(), kLine),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   title);
  const QRectF bar(room.left() + kSide, room.top() + kLine, room.width() - 2 * kSide, kHeight);
  QLinearGradient colours(bar.topLeft(), bar.topRight());
  for (int i = 0; i <= 16; ++i) {
    const MapColour c = scale.colour(i / 16.0);
    colours.setColorAt(i / 16.0, QColor(c.red, c.green, c.blue));
  }
  painter.fillRect(bar, colours);
  for (int i = 0; i <= scale.steps; ++i) {
    const double part = static_cast<double>(i) / scale.steps;
    const double x = bar.left() + part * bar.width();
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 3));
    painter.drawText(QRectF(x - 30, bar.bottom() + 2, 60, kLine),
                     Qt::AlignCenter,
                     QString::number(scale.low_mm + part * (scale.top_mm - scale.low_mm), 'g', 3));
  }
  return bar.bottom() + 2 + kLine;
}

void draw_length(QPainter& painter, const QRectF& room, double px_per_mm) {
  const double y = room.top() + 0.5 * kLine, end = room.left() + kLength_mm * px_per_mm;
  painter.setPen(QPen(Qt::black, 2));
  painter.drawLine(QPointF(room.left(), y), QPointF(end, y));
  painter.setPen(Qt::black);
  painter.drawText(QRectF(end + kGap, room.top(), room.right() - end, kLine),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   QString::number(kLength_mm) + " mm");
}

}  // namespace

QImage relief_image(const ExperimentMaps& maps, int width, double sharpness) {
  const auto columns = static_cast<int>(maps.depths.size());
  const cv::Mat& first = maps.depths.front().mm;
  const double map_width = (width - (columns - 1) * kGap - 1) / columns;
  const double map_height = map_width * first.rows / first.cols;
  const double row_height = kLine + map_height;
  QImage image(qRound(sharpness * width),
               qRound(sharpness * (2 * row_height + kGap + 1)),
               QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.scale(sharpness, sharpness);
  QFont font("DejaVu Sans");
  font.setPixelSize(11);
  painter.setFont(font);
  const ColourScale depths = depth_scale(maps.top_mm);
  const ColourScale differences = difference_scale(maps.difference_top_mm);
  const auto room_of = [&](int column, int row) {
    return QRectF(column * (map_width + kGap), row * (row_height + kGap), map_width, row_height);
  };
  for (int i = 0; i < columns; ++i)
    draw_map(painter, maps.depths[static_cast<std::size_t>(i)], depths, room_of(i, 0));
  for (int i = 0; i < static_cast<int>(maps.differences.size()); ++i)
    draw_map(
        painter, maps.differences[static_cast<std::size_t>(i)], differences, room_of(i + 1, 1));
  QRectF legend = room_of(0, 1).adjusted(0, 0, -kGap, 0);
  legend.setTop(draw_scale(painter, depths, text("Depth (mm)"), legend) + kGap / 2);
  legend.setTop(draw_scale(painter, differences, text("Told \u2212 true (mm)"), legend) + kGap);
  draw_length(painter, legend, map_width / (first.cols * maps.mm_per_cell));
  return image;
}

}  // namespace alltact
