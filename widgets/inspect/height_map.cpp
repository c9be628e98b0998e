#include "widgets/inspect/height_map.h"

#include "core/io/colour_map.h"
#include "widgets/picture/overlays.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

const QColor kHalo(0, 0, 0, 190);
const QColor kMark(255, 184, 0);

MapColour colour_of(double part, bool is_difference) {
  return is_difference ? cool_to_warm(2 * part - 1) : viridis(part);
}

void draw_point(QPainter& painter, QPointF at, const QString& letter) {
  constexpr double kRadius = 6;
  for (const auto& [colour, width] : {std::pair{kHalo, 4.5}, {kMark, 2.0}}) {
    painter.setPen(QPen(colour, width));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, kRadius, kRadius);
  }
  const QFontMetricsF metrics(painter.font());
  const QRectF label(at.x() + kRadius + 3,
                     at.y() - 0.5 * metrics.height(),
                     metrics.horizontalAdvance(letter) + 6,
                     metrics.height());
  painter.setPen(Qt::NoPen);
  painter.setBrush(kHalo);
  painter.drawRoundedRect(label, 3, 3);
  painter.setPen(kMark);
  painter.drawText(label, Qt::AlignCenter, letter);
}

}  // namespace

cv::Mat height_layer(const cv::Mat& value_mm, double top_mm, bool is_difference) {
  constexpr int kSteps = 256;
  std::array<cv::Vec4b, kSteps> table;
  for (int i = 0; i < kSteps; ++i) {
    const MapColour c = colour_of(static_cast<double>(i) / (kSteps - 1), is_difference);
    table[static_cast<std::size_t>(i)] = {c.blue, c.green, c.red, 255};
  }
  const double low = is_difference ? -top_mm : 0;
  const auto scale = static_cast<float>((kSteps - 1) / (top_mm - low));
  cv::Mat layer(value_mm.size(), CV_8UC4);
  for (int v = 0; v < layer.rows; ++v) {
    const auto* value = value_mm.ptr<float>(v);
    auto* pixel = layer.ptr<cv::Vec4b>(v);
    for (int u = 0; u < layer.cols; ++u) {
      pixel[u] = cv::Vec4b(0, 0, 0, 0);
      if (!std::isfinite(value[u])) continue;
      const float step = (value[u] - static_cast<float>(low)) * scale + 0.5F;
      pixel[u] = table[static_cast<std::size_t>(std::clamp(step, 0.0F, kSteps - 1.0F))];
    }
  }
  return layer;
}

Overlay points_overlay(const std::optional<cv::Point2d>& a, const std::optional<cv::Point2d>& b) {
  return [a, b](QPainter& painter, const ImageTransform& transform) {
    const auto place = [&](const cv::Point2d& at) { return transform.to_widget({at.x, at.y}); };
    if (a && b) {
      for (const auto& [colour, width] : {std::pair{kHalo, 4.5}, {kMark, 2.0}}) {
        painter.setPen(QPen(colour, width));
        painter.drawLine(place(*a), place(*b));
      }
    }
    if (a) draw_point(painter, place(*a), QStringLiteral("A"));
    if (b) draw_point(painter, place(*b), QStringLiteral("B"));
  };
}

Overlay height_scale_overlay(double top_mm, bool is_difference, const QString& title) {
  if (!is_difference) return colour_bar_overlay(top_mm, title);
  return [top_mm, title](QPainter& painter, const ImageTransform& /*transform*/) {
    const QRectF room(painter.viewport());
    const QFontMetricsF metrics(painter.font());
    constexpr double kHeight = 14, kMargin = 10, kGap = 8;
    const QLocale locale;
    const double width = std::clamp(0.3 * room.width(), 160.0, 280.0);
    const double number = metrics.horizontalAdvance(locale.toString(-top_mm, 'f', 2));
    const QSizeF size(width + number + 2 * kGap, kHeight + 2 * metrics.height() + 2 * kGap);
    const QRectF panel(
        QPointF(room.right() - kMargin - size.width(), room.bottom() - kMargin - size.height()),
        size);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kHalo);
    painter.drawRoundedRect(panel, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(panel.topLeft() + QPointF(kGap, kGap / 2 + metrics.ascent()), title);
    const QRectF bar(panel.left() + kGap + 0.5 * number,
                     panel.top() + kGap / 2 + metrics.height() + 3,
                     width,
                     kHeight);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    for (int i = 0; i <= 16; ++i) {
      const MapColour c = colour_of(i / 16.0, true);
      gradient.setColorAt(i / 16.0, QColor(c.red, c.green, c.blue));
    }
    painter.fillRect(bar, gradient);
    for (int i = -1; i <= 1; ++i) {
      const QString text = locale.toString(i * top_mm, 'f', 2);
      const double x = bar.center().x() + 0.5 * i * bar.width();
      painter.drawText(
          QPointF(x - 0.5 * metrics.horizontalAdvance(text), bar.bottom() + 3 + metrics.ascent()),
          text);
    }
  };
}

}  // namespace alltact
