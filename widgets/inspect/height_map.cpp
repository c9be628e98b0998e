#include "widgets/inspect/height_map.h"

#include "widgets/picture/overlays.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

const QColor kHalo(0, 0, 0, 190);
const QColor kMark(255, 184, 0);

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

cv::Mat height_layer(const cv::Mat& value_mm, const ColourScale& scale) {
  constexpr int kSteps = 256;
  std::array<cv::Vec4b, kSteps> table;
  for (int i = 0; i < kSteps; ++i) {
    const double part = static_cast<double>(i) / (kSteps - 1);
    const MapColour c = scale.colour(part);
    table[static_cast<std::size_t>(i)] = {c.blue, c.green, c.red, 255};
  }
  const auto low = static_cast<float>(scale.low_mm);
  const auto per_mm = static_cast<float>((kSteps - 1) / (scale.top_mm - scale.low_mm));
  cv::Mat layer(value_mm.size(), CV_8UC4);
  for (int v = 0; v < layer.rows; ++v) {
    const auto* value = value_mm.ptr<float>(v);
    auto* pixel = layer.ptr<cv::Vec4b>(v);
    for (int u = 0; u < layer.cols; ++u) {
      pixel[u] = cv::Vec4b(0, 0, 0, 0);
      if (!std::isfinite(value[u])) continue;
      const float step = (value[u] - low) * per_mm + 0.5F;
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
      painter.setPen(QPen(kMark, 1.0, Qt::DashLine));  // the box that is measured
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(QRectF(place(*a), place(*b)).normalized());
    }
    if (a) draw_point(painter, place(*a), QStringLiteral("A"));
    if (b) draw_point(painter, place(*b), QStringLiteral("B"));
  };
}

}  // namespace alltact
