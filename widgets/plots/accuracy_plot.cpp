#include "widgets/plots/accuracy_plot.h"

#include "widgets/accessible.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kTimeMargin = 1.6;      // times the slowest point on the front
constexpr double kMaxBudgetRatio = 2.5;  // times that: largest extension to the line
constexpr double kHeadroom = 1.12;       // axis height as a multiple of the largest whisker
constexpr double kClickRadiusPx = 12;    // from a dot
constexpr double kDotPx = 9;
constexpr int kFocusPx = 2;

}  // namespace

AccuracyPlot::AccuracyPlot(QWidget* parent) : Plot(parent) {
  layout()->setContentsMargins(kFocusPx, kFocusPx, kFocusPx, kFocusPx);
  setFocusPolicy(Qt::StrongFocus);
  set_accessible_role(*this, QAccessible::Chart);
  chart().setMouseTracking(true);
  connect(&chart(), &QCustomPlot::afterLayout, this, &AccuracyPlot::layout_labels_now);
  connect(&chart(), &QCustomPlot::mouseMove, this, &AccuracyPlot::hover);
  connect(&chart(), &QCustomPlot::mousePress, this, &AccuracyPlot::press);
}

void AccuracyPlot::set_points(std::vector<AccuracyPoint> points) {
  points_ = std::move(points);
  if (picked_ && *picked_ >= points_.size()) picked_.reset();
  announce();
  rebuild();
}

void AccuracyPlot::set_budget(double frames_per_s) {
  frames_per_s_ = frames_per_s;
  rebuild();
}

void AccuracyPlot::pick(std::optional<std::size_t> point) {
  if (point && *point >= points_.size()) point.reset();
  if (point == picked_) return;
  picked_ = point;
  announce();
  rebuild();
}

void AccuracyPlot::announce() {
  setAccessibleName(tr("What accuracy costs in time"));
  if (picked_)
    set_accessible_value(*this,
                         points_[*picked_].words + QLatin1Char('\n') + points_[*picked_].hint);
  else
    set_accessible_value(*this, empty_text());
}

QString AccuracyPlot::empty_text() const {
  return points_.empty() ? tr("Nothing has been measured yet") : tr("No setting is chosen");
}

std::vector<std::size_t> AccuracyPlot::front() const {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (points_[i].is_on_front) front.push_back(i);
  std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return points_[a].time_ms < points_[b].time_ms;
  });
  return front;
}

void AccuracyPlot::set_ranges() {
  // Limits the axes: far slower or worse points would squeeze the front into a corner.
  double slowest_ms = 0, worst_mm = 0;
  for (const AccuracyPoint& point : points_) {
    const bool matters =
        point.is_on_front || point.is_in_use || (picked_ && &points_[*picked_] == &point);
    if (!matters) continue;
    slowest_ms = std::max(slowest_ms, point.time_ms);
    worst_mm = std::max(worst_mm, point.p95_mm);
  }
  max_ms_ = std::max(kTimeMargin * slowest_ms, 1e-3);
  const double budget_ms = 1000 / frames_per_s_;
  if (budget_ms < kMaxBudgetRatio * slowest_ms) max_ms_ = std::max(max_ms_, 1.05 * budget_ms);
  max_mm_ = std::max(kHeadroom * worst_mm, 1e-4);
  chart().xAxis->setRange(0, max_ms_);
  chart().yAxis->setRange(0, max_mm_);
  chart().xAxis->setLabel(tr("Time of a picture on this computer (ms)"));
  chart().yAxis->setLabel(tr("Error of depth (mm)"));
}

bool AccuracyPlot::is_shown(const AccuracyPoint& point) const {
  return point.time_ms <= max_ms_ && point.median_mm <= max_mm_;
}

bool AccuracyPlot::draw() {
  labels_.clear();
  if (points_.empty()) return false;
  set_ranges();
  draw_others();
  draw_front();
  draw_marks();
  draw_budget();
  draw_labels();
  chart().legend->setIconSize(32, 20);
  show_legend();
  return true;
}

void AccuracyPlot::draw_others() {
  QColor grey = palette().color(QPalette::Text);
  grey.setAlpha(90);
  auto* others = chart().addGraph();
  others->setName(tr("slower or worse than another"));
  others->setLineStyle(QCPGraph::lsNone);
  others->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, grey, grey, kDotPx - 3));
  int beyond = 0;
  for (const AccuracyPoint& point : points_) {
    if (!is_shown(point))
      ++beyond;
    else if (!point.is_on_front)
      others->addData(point.time_ms, point.median_mm);
  }
  if (beyond > 0)
    add_note(max_ms_,
             0,
             tr("%n slower or worse, beyond this figure", "", beyond),
             Qt::AlignRight | Qt::AlignBottom);
}

void AccuracyPlot::draw_front() {
  const QColor colour = series_colour(0, palette());
  auto* stairs = chart().addGraph();
  auto* dots = chart().addGraph();
  stairs->setLineStyle(QCPGraph::lsStepLeft);
  stairs->setPen(QPen(colour, 1.5));
  stairs->removeFromLegend();
  dots->setName(tr("best for its time; whisker up to 95 %"));
  dots->setLineStyle(QCPGraph::lsNone);
  dots->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, kDotPx));
  const auto along = front();
  double min_mm = std::numeric_limits<double>::infinity();  // smallest so far, by time
  for (const std::size_t i : along) {
    const AccuracyPoint& point = points_[i];
    min_mm = std::min(min_mm, point.median_mm);
    stairs->addData(point.time_ms, min_mm);
    dots->addData(point.time_ms, point.median_mm);
    auto* whisker = new QCPItemLine(&chart());
    whisker->start->setCoords(point.time_ms, point.median_mm);
    whisker->end->setCoords(point.time_ms, point.p95_mm);
    whisker->setHead(QCPLineEnding(QCPLineEnding::esBar, 7, 0));
    whisker->setPen(QPen(colour, 1));
  }
  if (!along.empty()) stairs->addData(max_ms_, min_mm);
}

void AccuracyPlot::draw_marks() {
  const QColor text = palette().color(QPalette::Text);
  const auto mark =
      [&](const QString& name, const QCPScatterStyle& style, const AccuracyPoint& point) {
        auto* graph = chart().addGraph();
        graph->setName(name);
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(style);
        graph->addData(point.time_ms, point.median_mm);
      };
  if (picked_)
    mark(tr("chosen"),
         QCPScatterStyle(QCPScatterStyle::ssDiamond, text, series_colour(1, palette()), 15),
         points_[*picked_]);
  for (const AccuracyPoint& point : points_)
    if (point.is_in_use)
      mark(tr("in use now"),
           QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 2), Qt::NoBrush, 13),
           point);
}

void AccuracyPlot::draw_budget() {
  const double budget_ms = 1000 / frames_per_s_;
  const QColor colour = meaning_colour(Meaning::kBad, palette());
  const QString words = tr("%1 pictures per second").arg(QLocale().toString(frames_per_s_));
  if (budget_ms > max_ms_) {
    add_note(max_ms_,
             max_mm_,
             tr("%1: at %2 ms, further right →").arg(words, QLocale().toString(budget_ms, 'f', 1)),
             Qt::AlignRight | Qt::AlignTop);
    return;
  }
  auto* line = new QCPItemLine(&chart());
  line->start->setCoords(budget_ms, 0);
  line->end->setCoords(budget_ms, max_mm_);
  line->setPen(QPen(colour, 2, Qt::DashLine));
  const bool is_left = budget_ms < 0.5 * max_ms_;
  add_note(budget_ms, max_mm_, words, (is_left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignTop);
}

QPointF AccuracyPlot::pixel_of(const AccuracyPoint& point) const {
  return {chart().xAxis->coordToPixel(point.time_ms), chart().yAxis->coordToPixel(point.median_mm)};
}

QPoint AccuracyPlot::dot_pixel(std::size_t point) const {
  return chart().mapTo(this, pixel_of(points_[point]).toPoint());
}

std::vector<std::optional<QPointF>> AccuracyPlot::dots() const {
  std::vector<QPointF> drawn;
  for (int i = 0; i < chart().graphCount(); ++i)
    if (chart().graph(i)->lineStyle() == QCPGraph::lsNone)
      for (const QCPGraphData& data : *chart().graph(i)->data())
        drawn.emplace_back(data.key, data.value);
  std::vector<std::optional<QPointF>> dots;
  for (const AccuracyPoint& point : points_) {
    const auto found = std::find_if(drawn.begin(), drawn.end(), [&](const QPointF& dot) {
      return dot.x() == point.time_ms && dot.y() == point.median_mm;
    });
    dots.push_back(found == drawn.end() ? std::nullopt : std::optional(*found));
  }
  return dots;
}

std::optional<std::size_t> AccuracyPlot::at(const QPointF& pixel) const {
  std::optional<std::size_t> nearest;
  double least = kClickRadiusPx;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!is_shown(points_[i])) continue;
    const QPointF off = pixel - pixel_of(points_[i]);
    // Of overlapping dots the one on the front wins.
    const double far = std::hypot(off.x(), off.y()) - (points_[i].is_on_front ? 3 : 0);
    if (far < least) least = far, nearest = i;
  }
  return nearest;
}

void AccuracyPlot::hover(QMouseEvent* event) {
  const auto point = at(event->position());
  chart().setCursor(point ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (!point) return QToolTip::hideText();
  QToolTip::showText(event->globalPosition().toPoint(),
                     points_[*point].words + QLatin1Char('\n') + points_[*point].hint,
                     &chart());
}

void AccuracyPlot::press(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (event->button() != Qt::LeftButton) return;
  const auto point = at(event->position());
  if (!point) return;
  pick(point);
  Q_EMIT point_picked(*point);
}

void AccuracyPlot::walk(int steps) {
  const auto along = front();
  if (along.empty()) return;
  auto now = static_cast<int>(along.size()) - 1;
  if (picked_) {
    const double here_ms = points_[*picked_].time_ms;
    const auto found = std::find(along.begin(), along.end(), *picked_);
    now = 0;  // from a point off the front: as if from the next faster one on it
    for (std::size_t i = 0; i < along.size(); ++i)
      if (points_[along[i]].time_ms <= here_ms) now = static_cast<int>(i);
    if (found == along.end() && steps < 0) ++now;
  }
  const int next = std::clamp(now + steps, 0, static_cast<int>(along.size()) - 1);
  const std::size_t point = along[static_cast<std::size_t>(next)];
  pick(point);
  Q_EMIT point_picked(point);
}

void AccuracyPlot::keyPressEvent(QKeyEvent* event) {
  constexpr int kToTheEnd = 1 << 16;
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Up:
      return walk(-1);
    case Qt::Key_Right:
    case Qt::Key_Down:
      return walk(1);
    case Qt::Key_Home:
      return walk(-kToTheEnd);
    case Qt::Key_End:
      return walk(kToTheEnd);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (picked_) Q_EMIT point_activated();
      return;
    case Qt::Key_Escape:
      return void(Q_EMIT pick_cleared());
    default:
      Plot::keyPressEvent(event);
  }
}

void AccuracyPlot::paintEvent(QPaintEvent* event) {
  Plot::paintEvent(event);
  if (!hasFocus()) return;
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::Highlight), kFocusPx));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

}  // namespace alltact
