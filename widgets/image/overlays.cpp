#include "widgets/image/overlays.h"

#include "widgets/language.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

const QColor kHalo(0, 0, 0, 190);
const QColor kEdge(86, 180, 233);       // Okabe and Ito's sky blue
const QColor kSeen(255, 214, 64);       // yellow
const QColor kEstimated(240, 145, 90);  // orange
const QColor kArrow(47, 199, 155);      // bluish green
const QColor kText(255, 255, 255);

void write(QPainter& painter, QPointF centre, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  QPainterPath path;
  path.addText(centre.x() - 0.5 * metrics.horizontalAdvance(text),
               centre.y() + 0.5 * metrics.capHeight(), painter.font(), text);
  painter.setPen(QPen(kHalo, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(path);
  painter.fillPath(path, kText);
}

QPainterPath edge_path(const FaceEdges& edges, const Edge& edge, const ImageTransform& transform) {
  QPainterPath path;
  bool is_drawing = false;
  for (std::size_t i = 0; i < edges.u.size(); ++i) {
    if (edge.valid[i] == 0) {
      is_drawing = false;
      continue;
    }
    const QPointF at = transform.to_widget({edges.u[i], edge.v[i]});
    if (is_drawing)
      path.lineTo(at);
    else
      path.moveTo(at);
    is_drawing = true;
  }
  return path;
}

QPainterPath ring(QPointF centre, double radius) {
  QPainterPath path;
  path.addEllipse(centre, radius, radius);
  return path;
}

QPainterPath diamond(QPointF centre, double radius) {
  QPainterPath path;
  path.moveTo(centre + QPointF(0, -radius));
  for (const QPointF corner : {QPointF(radius, 0), QPointF(0, radius), QPointF(-radius, 0)})
    path.lineTo(centre + corner);
  path.closeSubpath();
  return path;
}

QPointF middle_of(const Markers& markers) {
  QPointF sum;
  for (const Marker& marker : markers) sum += QPointF(marker.u, marker.v);
  return sum / static_cast<double>(markers.size());
}

}  // namespace

void stroke_over(QPainter& painter, const QPainterPath& path, const QColor& colour, double width,
                 Qt::PenStyle style) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kHalo, width + 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(colour, width, style, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

Overlay edges_overlay(const FaceEdges& edges) {
  return [edges](QPainter& painter, const ImageTransform& transform) {
    for (const Edge* edge : {&edges.upper, &edges.lower})
      stroke_over(painter, edge_path(edges, *edge, transform), kEdge, 1.6);
  };
}

Overlay markers_overlay(const Markers& markers) {
  return [markers](QPainter& painter, const ImageTransform& transform) {
    const double radius = std::max(7.0, 9 * transform.scale);
    for (std::size_t m = 0; m < markers.size(); ++m) {
      const Marker& marker = markers[m];
      const QPointF at = transform.to_widget({marker.u, marker.v});
      if (marker.seen)
        stroke_over(painter, ring(at, radius), kSeen, 1.8);
      else
        stroke_over(painter, diamond(at, 1.25 * radius), kEstimated, 1.8, Qt::DashLine);
      // Numbers stand off the face: above the upper row, below the lower one.
      const double side = 2 * m < markers.size() ? -1 : 1;
      write(painter, at + QPointF(0, side * (radius + 11)), QString::number(m));
    }
  };
}

Overlay dots_overlay(const std::vector<Dot>& dots) {
  return [dots](QPainter& painter, const ImageTransform& transform) {
    const double half = std::max(5.0, 6 * transform.scale);
    for (const Dot& dot : dots) {
      QPainterPath square;
      square.addRect(QRectF(transform.to_widget({dot.u, dot.v}) - QPointF(half, half),
                            QSizeF(2 * half, 2 * half)));
      stroke_over(painter, square, kEstimated, 1.5);
    }
  };
}

Overlay force_overlay(const Push& push, const Markers& markers) {
  if (!push.direction || markers.empty()) return [](QPainter&, const ImageTransform&) {};
  const QPointF from = middle_of(markers);
  const QPointF direction(push.direction->x(), push.direction->y());
  return [from, direction](QPainter& painter, const ImageTransform& transform) {
    constexpr double kLength = 70, kHead = 16;
    const QPointF start = transform.to_widget(from), end = start + kLength * direction;
    const QPointF across(-direction.y(), direction.x());
    QPainterPath arrow;
    arrow.moveTo(start);
    arrow.lineTo(end);
    arrow.moveTo(end - kHead * direction + 0.6 * kHead * across);
    arrow.lineTo(end);
    arrow.lineTo(end - kHead * direction - 0.6 * kHead * across);
    stroke_over(painter, arrow, kArrow, 4);
  };
}

Overlay layer_overlay(const cv::Mat& layer, cv::Point at) {
  return [layer, at](QPainter& painter, const ImageTransform& transform) {
    if (layer.empty()) return;
    const QImage image(layer.data, layer.cols, layer.rows, static_cast<qsizetype>(layer.step),
                       QImage::Format_ARGB32_Premultiplied);
    const QRectF covered = transform.covered(image.size());
    painter.drawImage(covered.translated(QPointF(at.x, at.y) * transform.scale), image);
  };
}

namespace {

/// `at`: the upper left corner of the plate.
void write_on_plate(QPainter& painter, QPointF at, const QString& words, const QColor& colour) {
  constexpr double kSide = 7, kUpper = 4;
  const QFontMetricsF metrics(painter.font());
  const QRectF room(at, metrics.size(0, words) + QSizeF(2 * kSide, 2 * kUpper));
  painter.setPen(Qt::NoPen);
  painter.setBrush(kHalo);
  painter.drawRoundedRect(room, 4, 4);
  painter.setPen(colour);
  painter.drawText(room.adjusted(kSide, kUpper, -kSide, -kUpper), 0, words);
}

}  // namespace

Overlay banner_overlay(const QString& words) {
  return [words](QPainter& painter, const ImageTransform& /*transform*/) {
    write_on_plate(painter, QRectF(painter.viewport()).topLeft() + QPointF(8, 8), words, kText);
  };
}

Overlay flash_overlay(const QString& words) {
  return [words](QPainter& painter, const ImageTransform& /*transform*/) {
    constexpr double kBorder = 10;
    const QRectF room(painter.viewport());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kSeen, kBorder));
    painter.drawRect(room.adjusted(kBorder / 2, kBorder / 2, -kBorder / 2, -kBorder / 2));
    QFont font = painter.font();
    font.setPointSizeF(2 * font.pointSizeF());
    font.setBold(true);
    painter.setFont(font);
    const QSizeF size = QFontMetricsF(font).size(0, words);
    write_on_plate(painter,
                   room.center() - QPointF(0.5 * size.width() + 7, 0.5 * size.height() + 4), words,
                   kText);
  };
}

void write_next_to(QPainter& painter, QPointF widget, const QString& words, const QColor& colour) {
  const QRectF room = QRectF(painter.viewport()).adjusted(4, 4, -4, -4);
  const QSizeF size = QFontMetricsF(painter.font()).size(0, words) + QSizeF(14, 8);
  QPointF at = widget;
  at.setX(std::clamp(at.x(), room.left(), std::max(room.left(), room.right() - size.width())));
  at.setY(std::clamp(at.y(), room.top(), std::max(room.top(), room.bottom() - size.height())));
  write_on_plate(painter, at, words, colour);
}

void fill_scale_ends(QPainter& painter, const QRectF& bar) {
  const double length = 0.5 * bar.height();
  for (const bool is_top : {false, true}) {
    const double x = is_top ? bar.right() : bar.left();
    QPainterPath point(QPointF(x, bar.top()));
    point.lineTo(x + (is_top ? length : -length), bar.center().y());
    point.lineTo(x, bar.bottom());
    const MapColour colour = is_top ? kAboveScale : kBelowScale;
    painter.fillPath(point, QColor(colour.red, colour.green, colour.blue));
  }
}

Overlay colour_bar_overlay(const ColourScale& scale, const QString& title,
                           const std::vector<LegendLine>& legend) {
  return [scale, title, legend](QPainter& painter, const ImageTransform& /*transform*/) {
    const QRectF room(painter.viewport());
    const QFontMetricsF metrics(painter.font());
    constexpr double kHeight = 14, kMargin = 10, kGap = 8;
    const int decimals = scale.label_decimals(scale.steps + 1);
    const auto number_at = [&](int step) {
      const double part = static_cast<double>(step) / scale.steps;
      return plain_number(scale.low_mm + part * (scale.top_mm - scale.low_mm), decimals);
    };
    double width = std::clamp(0.3 * room.width(), 160.0, 280.0);
    const double sample = 1.6 * metrics.height();
    for (const LegendLine& line : legend)
      width = std::max(width, sample + kGap + metrics.horizontalAdvance(line.words));
    const double number = std::max(metrics.horizontalAdvance(number_at(0)),
                                   metrics.horizontalAdvance(number_at(scale.steps)));
    const double line_height = 1.25 * metrics.height();
    const double lines = line_height * static_cast<double>(legend.size());
    const double height = kHeight + 2 * metrics.height() + 2 * kGap + lines;
    const QRectF panel(room.right() - kMargin - width - number - 2 * kGap,
                       room.bottom() - kMargin - height, width + number + 2 * kGap, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kHalo);
    painter.drawRoundedRect(panel, 4, 4);
    painter.setPen(kText);
    double top = panel.top() + kGap / 2;
    for (const LegendLine& line : legend) {
      const QRectF patch(panel.left() + kGap, top + 2, sample, metrics.height() - 2);
      painter.fillRect(patch, QColor(38, 130, 142));
      painter.setBrushOrigin(patch.topLeft());
      painter.fillRect(patch, line.pattern);
      painter.setBrushOrigin(0, 0);
      painter.drawText(QPointF(patch.right() + kGap, top + metrics.ascent()), line.words);
      top += line_height;
    }
    painter.drawText(QPointF(panel.left() + kGap, top + metrics.ascent()), title);
    const QRectF bar(panel.left() + kGap + 0.5 * number, top + metrics.height() + 3, width,
                     kHeight);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 20;  // one of them at the zero of every scale
    for (int i = 0; i <= kStops; ++i) {
      const double part = static_cast<double>(i) / kStops;
      const MapColour colour = scale.colour(part);
      gradient.setColorAt(part, QColor(colour.red, colour.green, colour.blue));
    }
    painter.fillRect(bar, gradient);
    fill_scale_ends(painter, bar);
    if (scale.low_mm < 0 && scale.top_mm > 0) {
      const double zero = bar.left() - bar.width() * scale.low_mm / (scale.top_mm - scale.low_mm);
      painter.drawLine(QPointF(zero, bar.top() - 2), QPointF(zero, bar.bottom() + 2));
    }
    for (int i = 0; i <= scale.steps; ++i) {
      const QString text = number_at(i);
      const double x = bar.left() + bar.width() * i / scale.steps;
      painter.drawText(
          QPointF(x - 0.5 * metrics.horizontalAdvance(text), bar.bottom() + 3 + metrics.ascent()),
          text);
    }
  };
}

}  // namespace alltact
