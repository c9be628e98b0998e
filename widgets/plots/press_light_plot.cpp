#include "widgets/plots/press_light_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>

namespace alltact {

void PressLightPlot::set_data(std::vector<PressLight> presses, double limit_percent) {
  presses_ = std::move(presses);
  limit_percent_ = limit_percent;
  setAccessibleName(tr("Light of every press"));
  rebuild();
}

QString PressLightPlot::empty_text() const {
  return tr("No presses yet");
}

bool PressLightPlot::draw() {
  if (presses_.empty()) return false;
  auto* bars = new QCPBars(chart().xAxis, chart().yAxis);
  bars->setWidth(0.6);
  bars->setPen(Qt::NoPen);
  bars->setBrush(series_colour(0, palette()));
  double reach = 1.3 * limit_percent_;
  double number = 1;
  for (const PressLight& press : presses_) {
    bars->addData(number++, press.percent);
    reach = std::max(reach, 1.15 * std::abs(press.percent));
  }
  if (!(reach > 0)) reach = 1;
  const double last = static_cast<double>(presses_.size());
  chart().xAxis->setRange(0.3, last + 0.7);
  chart().yAxis->setRange(-reach, reach);
  QSharedPointer<QCPAxisTickerFixed> integer_ticks(new QCPAxisTickerFixed);
  integer_ticks->setTickStep(std::max(1.0, std::ceil(last / 12)));
  chart().xAxis->setTicker(integer_ticks);
  chart().xAxis->grid()->setVisible(false);
  chart().xAxis->setLabel(tr("Press, by number"));
  chart().yAxis->setLabel(tr("Light (%)"));
  for (const double limit : {-limit_percent_, 0.0, limit_percent_}) {
    auto* line = new QCPItemLine(&chart());
    line->start->setCoords(0, limit);
    line->end->setCoords(last + 1, limit);
    line->setPen(
        QPen(palette().color(QPalette::Text), 1, limit == 0 ? Qt::SolidLine : Qt::DashLine));
  }
  return true;
}

}  // namespace alltact
