#include "widgets/plots/presses_plot.h"

#include "widgets/joined_words.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>

namespace alltact {

PressesPlot::PressesPlot(QWidget* parent) : Plot(parent) {
  setAccessibleName(tr("Error of depth by the number of presses"));
}

void PressesPlot::set_points(std::vector<PressesPoint> points) {
  points_ = std::move(points);
  QStringList words;
  for (const PressesPoint& point : points_)
    words << tr("%n press(es): %1 µm", nullptr, point.presses)
                 .arg(QLocale().toString(1000 * point.median_mm, 'f', 1));
  setAccessibleDescription(joined_clauses(words));
  rebuild();
}

QString PressesPlot::empty_text() const {
  return tr("Nothing is worked out yet");
}

bool PressesPlot::draw() {
  if (points_.empty()) return false;
  const QColor painted = series_colour(0, palette()), real = series_colour(1, palette());
  auto* line = chart().addGraph();
  auto* now = chart().addGraph();
  auto* pressed = chart().addGraph();
  auto* whiskers = new QCPErrorBars(chart().xAxis, chart().yAxis);
  whiskers->setDataPlottable(line);
  whiskers->setPen(QPen(painted));
  whiskers->removeFromLegend();
  double highest = 0, tallest = 0;
  for (const PressesPoint& point : points_) {
    const double presses = point.presses, median_um = 1000 * point.median_mm,
                 p95_um = 1000 * point.p95_mm;
    line->addData(presses, median_um);
    whiskers->addData(0, p95_um - median_um);
    if (point.is_current) now->addData(presses, median_um);
    if (point.real_median_mm) pressed->addData(presses, 1000 * *point.real_median_mm);
    // A single press may be far off and would squash the others.
    if (point.presses > 2 || points_.size() < 3) tallest = std::max(tallest, p95_um);
    highest = std::max(highest, p95_um);
  }
  line->setName(tr("painted balls, whisker to 95 %"));
  line->setPen(QPen(painted, 2));
  line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, painted, 7));
  now->setName(tr("presses there are now"));
  now->setLineStyle(QCPGraph::lsNone);
  now->setScatterStyle(QCPScatterStyle(
      QCPScatterStyle::ssCircle, QPen(palette().text().color(), 2), Qt::NoBrush, 13));
  pressed->setName(tr("real presses left out"));
  pressed->setLineStyle(QCPGraph::lsNone);
  pressed->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(real, 2), Qt::NoBrush, 8));
  if (pressed->data()->isEmpty()) pressed->removeFromLegend();
  chart().xAxis->setRange(points_.front().presses - 0.5, points_.back().presses + 0.5);
  auto integer_ticks = QSharedPointer<QCPAxisTickerFixed>::create();
  integer_ticks->setTickStep(1);
  integer_ticks->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  chart().xAxis->setTicker(integer_ticks);
  chart().xAxis->setLabel(tr("Presses"));
  chart().yAxis->setRange(0, 1.1 * std::max(tallest > 0 ? tallest : highest, 1e-3));
  chart().yAxis->setLabel(tr("Error of depth (µm)"));
  show_legend();
  return true;
}

}  // namespace alltact
