#include "widgets/recording/coverage_view.h"

#include "widgets/accessible.h"
#include "widgets/joined_words.h"
#include "widgets/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kShown = BendState::kShown;
constexpr double kSign = 12;

double part_of(double value, double need) {
  return need > 0 ? std::clamp(value / need, -kShown, kShown) : 0;
}

}  // namespace

QString bend_direction_text(BendDirection direction) {
  switch (direction) {
    case BendDirection::kAway:
      return CoverageView::tr("bend away");
    case BendDirection::kTowards:
      return CoverageView::tr("bend back");
    case BendDirection::kUp:
      return CoverageView::tr("sway up");
    case BendDirection::kDown:
      return CoverageView::tr("sway down");
    case BendDirection::kTwistRight:
      return CoverageView::tr("twist right");
    case BendDirection::kTwistLeft:
      break;
  }
  return CoverageView::tr("twist left");
}

CoverageView::CoverageView(QWidget* parent) : Translated(parent) {
  set_accessible_role(*this, QAccessible::Chart);
  say([this] {
    setAccessibleName(tr("Coverage of bending"));
    describe();
  });
}

void CoverageView::show_coverage(const BendState& coverage) {
  coverage_ = coverage;
  describe();
  update();
}

void CoverageView::describe() {
  QStringList missing;
  for (const BendDirection direction : coverage_.missing())
    missing << bend_direction_text(direction);
  set_accessible_description(*this,
                             coverage_.poses == 0 ? tr("No pose has been seen yet.")
                             : missing.isEmpty()  ? tr("Enough: all directions are reached.")
                                                  : tr("Missing: %1.").arg(listed(missing)));
}

void CoverageView::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update();
}

void CoverageView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double line = fontMetrics().height() + 4.0;
  const double twist = 2 * line + 10;
  const double side = std::min(width() - 2.0, height() - 2 * line - twist - 8);
  const QRectF field(0.5 * (width() - side), line, side, side);
  paint_field(painter, field);
  paint_label(painter, {field.left(), 0, side, line}, Qt::AlignCenter, BendDirection::kUp);
  paint_label(
      painter, {field.left(), field.bottom(), side, line}, Qt::AlignCenter, BendDirection::kDown);
  // One above the axis and one below it, so that long words fit.
  const QRectF above(field.left() + 6, field.center().y() - line - 2, side - 12, line);
  const QRectF under(field.left() + 6, field.center().y() + 2, side - 12, line);
  paint_label(painter, above, Qt::AlignLeft | Qt::AlignVCenter, BendDirection::kTowards);
  paint_label(painter, under, Qt::AlignRight | Qt::AlignVCenter, BendDirection::kAway);
  const QRectF below(field.left(), field.bottom() + line + 6, side, line);
  paint_label(painter, below, Qt::AlignLeft | Qt::AlignVCenter, BendDirection::kTwistLeft);
  paint_label(painter, below, Qt::AlignRight | Qt::AlignVCenter, BendDirection::kTwistRight);
  paint_twist(painter, {field.left(), below.bottom() + 2, side, line - 4});
}

void CoverageView::paint_field(QPainter& painter, const QRectF& field) const {
  const QColor line = palette().color(QPalette::Disabled, QPalette::Text);
  painter.fillRect(field, palette().color(QPalette::Base));
  constexpr int n = BendState::kCells;
  const double step = field.width() / n;
  const QColor visited = series_colour(0, palette());
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      const auto visits = coverage_.visits[static_cast<std::size_t>(row * n + column)];
      if (visits == 0) continue;
      QColor colour = visited;
      colour.setAlphaF(static_cast<float>(std::min(1.0, 0.35 + 0.1 * std::log2(visits))));
      painter.fillRect(QRectF(field.left() + column * step, field.top() + row * step, step, step),
                       colour);
    }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(line, 1));
  painter.drawRect(field);
  const double reach = 0.5 * field.width() / kShown;
  painter.setPen(QPen(line, 1, Qt::DashLine));
  painter.drawRect(QRectF(field.center() - QPointF(reach, reach), QSizeF(2 * reach, 2 * reach)));
  painter.drawLine(QPointF(field.left(), field.center().y()),
                   QPointF(field.right(), field.center().y()));
  painter.drawLine(QPointF(field.center().x(), field.top()),
                   QPointF(field.center().x(), field.bottom()));
  if (!coverage_.now) return;
  const QPointF at =
      field.center() + QPointF(part_of(coverage_.now->bend_mm, coverage_.need.bend_mm) * reach,
                               part_of(coverage_.now->sway_mm, coverage_.need.sway_mm) * reach);
  painter.setPen(QPen(palette().color(QPalette::Base), 2));
  painter.setBrush(palette().color(QPalette::Text));
  painter.drawEllipse(at, 6, 6);
}

void CoverageView::paint_twist(QPainter& painter, const QRectF& bar) const {
  painter.fillRect(bar, palette().color(QPalette::Base));
  const auto reached = [&](BendDirection direction) {
    return std::min(coverage_.reached[static_cast<std::size_t>(direction)], kShown);
  };
  const double half = 0.5 * bar.width() / kShown;
  const double left = std::max(0.0, reached(BendDirection::kTwistLeft)) * half;
  const double right = std::max(0.0, reached(BendDirection::kTwistRight)) * half;
  painter.fillRect(QRectF(bar.center().x() - left, bar.top(), left + right, bar.height()),
                   series_colour(0, palette()));
  const QColor line = palette().color(QPalette::Disabled, QPalette::Text);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(line, 1));
  painter.drawRect(bar);
  painter.setPen(QPen(line, 1, Qt::DashLine));
  for (const double x : {bar.center().x() - half, bar.center().x(), bar.center().x() + half})
    painter.drawLine(QPointF(x, bar.top()), QPointF(x, bar.bottom()));
  if (!coverage_.now) return;
  const double x =
      bar.center().x() + part_of(coverage_.now->twist_deg, coverage_.need.twist_deg) * half;
  painter.setPen(QPen(palette().color(QPalette::Base), 2));
  painter.setBrush(palette().color(QPalette::Text));
  painter.drawEllipse(QPointF(x, bar.center().y()), 6, 6);
}

void CoverageView::paint_label(QPainter& painter,
                               const QRectF& room,
                               int flags,
                               BendDirection direction) const {
  const QString text = bend_direction_text(direction);
  const bool is_reached = coverage_.reached[static_cast<std::size_t>(direction)] >= 1;
  const bool is_inside = direction == BendDirection::kAway || direction == BendDirection::kTowards;
  const double text_width = fontMetrics().horizontalAdvance(text), gap = 5;
  const double total_width = kSign + gap + text_width;
  double left = room.left();
  if ((flags & Qt::AlignHCenter) != 0) left = room.center().x() - 0.5 * total_width;
  if ((flags & Qt::AlignRight) != 0) left = room.right() - total_width;
  if (is_inside) {  // so that no line crosses the text
    QColor ground = palette().color(QPalette::Base);
    ground.setAlphaF(0.85F);
    painter.fillRect(QRectF(left - 3, room.top() + 1, total_width + 6, room.height() - 2), ground);
  }
  paint_sign(painter, {left + 0.5 * kSign, room.center().y()}, is_reached);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(left + kSign + gap, room.top(), text_width + 2, room.height()),
                   Qt::AlignVCenter | Qt::AlignLeft,
                   text);
}

void CoverageView::paint_sign(QPainter& painter, QPointF centre, bool is_reached) const {
  const double r = 0.4 * kSign;
  QPainterPath path;
  if (is_reached) {
    path.moveTo(centre + QPointF(-r, 0));
    path.lineTo(centre + QPointF(-0.2 * r, 0.8 * r));
    path.lineTo(centre + QPointF(r, -0.8 * r));
  } else {
    path.addEllipse(centre, r, r);
  }
  const QColor colour = meaning_colour(is_reached ? Meaning::kGood : Meaning::kDoubtful, palette());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

}  // namespace alltact
