#include "widgets/plots/history_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>

namespace alltact {

void HistoryPlot::set_data(HistoryData data) {
  data_ = std::move(data);
  std::stable_sort(data_.points.begin(), data_.points.end(), [](const auto& a, const auto& b) {
    return a.time_s < b.time_s;
  });
  setAccessibleName(tr("Checks over time"));
  rebuild();
}

QString HistoryPlot::empty_text() const {
  return tr("Not checked yet since the calibration");
}

void HistoryPlot::draw_band(double from_mm, double to_mm, QColor colour, const QString& word) {
  if (!(to_mm > from_mm)) return;
  auto* band = new QCPItemRect(&chart());
  band->setLayer("background");
  band->topLeft->setCoords(chart().xAxis->range().lower, to_mm);
  band->bottomRight->setCoords(chart().xAxis->range().upper, from_mm);
  band->setPen(Qt::NoPen);
  add_note(chart().xAxis->range().upper,
           0.5 * (from_mm + to_mm),
           word,
           Qt::AlignRight | Qt::AlignVCenter);
  colour.setAlpha(40);
  band->setBrush(colour);
}

bool HistoryPlot::draw() {
  if (data_.points.empty()) return false;
  double worst = 1.35 * data_.recalibrate_above_mm;
  for (const auto& point : data_.points) worst = std::max(worst, 1.1 * point.error_mm);
  const double first = data_.points.front().time_s, last = data_.points.back().time_s;
  const double room = std::max(1800.0, 0.08 * (last - first));
  // Leaves room for the bands' labels right of the last point.
  chart().xAxis->setRange(first - room, last + 3.0 * room);
  chart().yAxis->setRange(0, worst);
  draw_band(0, data_.drifting_above_mm, meaning_colour(Meaning::kGood, palette()), tr("pass"));
  draw_band(data_.drifting_above_mm,
            data_.recalibrate_above_mm,
            meaning_colour(Meaning::kDoubtful, palette()),
            tr("drifting"));
  draw_band(data_.recalibrate_above_mm,
            worst,
            meaning_colour(Meaning::kBad, palette()),
            tr("recalibrate"));

  auto* line = chart().addGraph();
  for (const auto& point : data_.points) line->addData(point.time_s, point.error_mm);
  line->setPen(QPen(series_colour(0, palette()), 2));
  line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, series_colour(0, palette()), 7));
  QSharedPointer<QCPAxisTickerDateTime> dates(new QCPAxisTickerDateTime);
  dates->setDateTimeSpec(Qt::UTC);
  dates->setDateTimeFormat(last - first > 86400.0 ? "yyyy-MM-dd" : "yyyy-MM-dd\nHH:mm");
  dates->setTickCount(4);
  chart().xAxis->setTicker(dates);
  chart().xAxis->setLabel(tr("Time (UTC)"));
  chart().yAxis->setLabel(tr("Depth error (mm)"));
  return true;
}

}  // namespace alltact
