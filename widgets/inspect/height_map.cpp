#include "widgets/inspect/height_map.h"

#include "core/sensing/depth/depth_limits.h"
#include "widgets/image/overlays.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

const QColor kHalo(0, 0, 0, 190);
const QColor kMark(255, 184, 0);

constexpr int kPeriod = 12;  // px, of every pattern

struct Pattern {
  std::uint8_t limits;  // bits of DepthLimit
  cv::Vec4b bgra;       // premultiplied
  bool (*is_drawn)(int u, int v);
};
/// The first matching pattern is drawn.
const std::array<Pattern, 4> kPatterns{
    {{kDepthClamped, {255, 255, 255, 255}, [](int u, int v) { return (u + v) % 6 < 2; }},
     {kOutOfRange, {0, 0, 0, 255}, [](int u, int v) { return (u + 5 * v) % 6 < 2; }},
     {kDoubtfulLight,
      {60, 150, 255, 255},
      [](int u, int v) { return (u + 6) % 12 < 2 && (v + 6) % 12 < 2; }},
     {kSteep, {120, 120, 120, 120}, [](int u, int v) { return u % 6 == 3 && v % 6 == 3; }}}};

struct LimitWords {
  Q_DECLARE_TR_FUNCTIONS(alltact::LimitWords)
 public:
  static QString of(std::uint8_t limits) {
    switch (limits) {
      case kDepthClamped:
        return tr("at the layer's limit");
      case kOutOfRange:
        return tr("beyond what was calibrated");
      case kDoubtfulLight:
        return tr("doubtful light");
      default:
        return tr("steep: its place matters");
    }
  }
};

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

cv::Mat limits_layer(const cv::Mat& limits) {
  cv::Mat layer = cv::Mat::zeros(limits.size(), CV_8UC4);
  bool is_empty = true;
  for (int v = 0; v < limits.rows; ++v) {
    const auto* bits = limits.ptr<std::uint8_t>(v);
    auto* pixel = layer.ptr<cv::Vec4b>(v);
    for (int u = 0; u < limits.cols; ++u)
      for (const Pattern& pattern : kPatterns)
        if ((bits[u] & pattern.limits) != 0 && pattern.is_drawn(u, v)) {
          pixel[u] = pattern.bgra;
          is_empty = false;
          break;
        }
  }
  return is_empty ? cv::Mat() : layer;
}

std::vector<LegendLine> limits_legend(const cv::Mat& limits) {
  constexpr int kMinPixels = 30;
  std::vector<LegendLine> legend;
  for (const Pattern& pattern : kPatterns) {
    int count = 0;
    for (int v = 0; v < limits.rows; ++v)
      count += static_cast<int>(std::count_if(
          limits.ptr<std::uint8_t>(v), limits.ptr<std::uint8_t>(v) + limits.cols, [&](auto bits) {
            return (bits & pattern.limits) != 0;
          }));
    if (count < kMinPixels) continue;
    QImage tile(kPeriod, kPeriod, QImage::Format_ARGB32_Premultiplied);
    tile.fill(Qt::transparent);
    for (int v = 0; v < kPeriod; ++v)
      for (int u = 0; u < kPeriod; ++u)
        if (pattern.is_drawn(u, v))
          tile.setPixel(
              u, v, qRgba(pattern.bgra[2], pattern.bgra[1], pattern.bgra[0], pattern.bgra[3]));
    legend.push_back({QBrush(tile), LimitWords::of(pattern.limits)});
  }
  return legend;
}

Overlay points_overlay(const std::optional<cv::Point2d>& a, const std::optional<cv::Point2d>& b) {
  return [a, b](QPainter& painter, const ImageTransform& transform) {
    const auto widget_point = [&](const cv::Point2d& at) {
      return transform.to_widget({at.x, at.y});
    };
    if (a && b) {
      for (const auto& [colour, width] : {std::pair{kHalo, 4.5}, {kMark, 2.0}}) {
        painter.setPen(QPen(colour, width));
        painter.drawLine(widget_point(*a), widget_point(*b));
      }
      painter.setPen(QPen(kMark, 1.0, Qt::DashLine));  // the measured box
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(QRectF(widget_point(*a), widget_point(*b)).normalized());
    }
    if (a) draw_point(painter, widget_point(*a), QStringLiteral("A"));
    if (b) draw_point(painter, widget_point(*b), QStringLiteral("B"));
  };
}

}  // namespace alltact
