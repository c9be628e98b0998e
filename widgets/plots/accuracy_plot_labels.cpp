// The labels of AccuracyPlot.
#include "widgets/plots/accuracy_plot.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/plots/label_layout.h"

#include <QTextLayout>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kNamedApartPx = 12;  // nearer dots share the label of their neighbour
constexpr double kLabelWidthPx = 170;

QString in_lines(const QString& text, const QFont& font) {
  QTextLayout layout(text, font);
  layout.beginLayout();
  QStringList lines;
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(kLabelWidthPx);
    lines << text.mid(line.textStart(), line.textLength()).trimmed();
  }
  layout.endLayout();
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

// The picked one, the one in use, and the front from its accurate end on, without near neighbours.
std::vector<std::size_t> AccuracyPlot::named() const {
  std::vector<std::size_t> named;
  const auto add = [&](std::size_t point, bool must) {
    if (named.size() >= kMaxLabels || !is_shown(points_[point]) ||
        std::find(named.begin(), named.end(), point) != named.end())
      return;
    const QPointF here = pixel_of(points_[point]);
    const bool is_apart = std::all_of(named.begin(), named.end(), [&](std::size_t other) {
      const QPointF off = here - pixel_of(points_[other]);
      return std::hypot(off.x(), off.y()) > kNamedApartPx;
    });
    if (must || is_apart) named.push_back(point);
  };
  if (picked_) add(*picked_, true);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].is_in_use) add(i, true);
  const auto along = front();
  if (!along.empty()) add(along.front(), false);
  for (auto at = along.rbegin(); at != along.rend(); ++at) add(*at, false);
  return named;
}

void AccuracyPlot::draw_labels() {
  for (std::size_t i = 0; i < kMaxLabels; ++i) {
    Label label{0, new QCPItemText(&chart()), new QCPItemLine(&chart())};
    label.text->position->setType(QCPItemPosition::ptAbsolute);
    label.text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    label.text->setTextAlignment(Qt::AlignLeft);
    label.text->setFont(font());
    label.text->setColor(palette().color(QPalette::Text));
    label.text->setPadding(QMargins(2, 1, 2, 1));
    QColor ground = palette().color(QPalette::Base);
    ground.setAlpha(200);
    label.text->setBrush(ground);
    label.line->start->setType(QCPItemPosition::ptAbsolute);
    label.line->end->setType(QCPItemPosition::ptAbsolute);
    QColor faint = palette().color(QPalette::Text);
    faint.setAlpha(120);
    label.line->setPen(QPen(faint, 1));
    label.text->setVisible(false);
    label.line->setVisible(false);
    labels_.push_back(label);
  }
}

// Called after the layout of the axes: pixel coordinates are valid only then.
void AccuracyPlot::layout_labels_now() {
  if (labels_.empty()) return;
  const std::vector<std::size_t> points = named();
  const QFontMetricsF metrics(font());
  std::vector<LabelRequest> requests;
  std::vector<QString> words;
  for (const std::size_t point : points) {
    words.push_back(in_lines(points_[point].words, font()));
    const QSizeF size = metrics.boundingRect(QRectF(0, 0, 1000, 1000), 0, words.back()).size();
    requests.push_back({pixel_of(points_[point]), size + QSizeF(6, 4)});
  }
  std::vector<QRectF> taken;
  for (const AccuracyPoint& point : points_) {
    if (!is_shown(point)) continue;
    const QPointF here = pixel_of(point);
    const double reach = point.is_on_front || point.is_in_use ? 6 : 2;
    taken.emplace_back(here - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach));
    if (!point.is_on_front) continue;
    const double top = chart().yAxis->coordToPixel(point.p95_mm);
    taken.emplace_back(QPointF(here.x() - 1, top), QPointF(here.x() + 1, here.y()));
  }
  QRectF room = chart().axisRect()->rect();
  room.adjust(2, metrics.height() + 8, -2, -metrics.height() - 8);  // notes above and below
  const auto boxes = layout_labels(room, requests, taken);
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    Label& label = labels_[i];
    const bool is_there = i < boxes.size() && boxes[i];
    label.text->setVisible(is_there);
    label.line->setVisible(is_there);
    if (!is_there) continue;
    label.point = points[i];
    label.text->setText(words[i]);
    label.text->position->setCoords(boxes[i]->topLeft());
    const QPointF dot = requests[i].dot;
    label.line->start->setCoords(dot);
    label.line->end->setCoords(std::clamp(dot.x(), boxes[i]->left(), boxes[i]->right()),
                               std::clamp(dot.y(), boxes[i]->top(), boxes[i]->bottom()));
  }
}

std::vector<QRectF> AccuracyPlot::label_boxes() const {
  std::vector<QRectF> boxes;
  for (const Label& label : labels_)
    if (label.text->visible())
      boxes.emplace_back(label.text->topLeft->pixelPosition(),
                         label.text->bottomRight->pixelPosition());
  return boxes;
}

}  // namespace alltact
