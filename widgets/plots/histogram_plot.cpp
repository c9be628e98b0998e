#include "widgets/plots/histogram_plot.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kBins = 41;  // not even, so that one bin is centred at zero

}  // namespace

void HistogramPlot::set_data(std::vector<double> errors_mm, const QString& axis) {
  std::erase_if(errors_mm, [](double error) { return !std::isfinite(error); });
  std::sort(errors_mm.begin(), errors_mm.end());
  errors_mm_ = std::move(errors_mm);
  axis_ = axis;
  std::vector<double> sizes;
  for (const double error : errors_mm_) sizes.push_back(std::abs(error));
  std::sort(sizes.begin(), sizes.end());
  error_95_mm_ =
      sizes.empty() ? 0.0
                    : sizes[static_cast<std::size_t>(0.95 * static_cast<double>(sizes.size() - 1))];
  setAccessibleName(tr("Spread of the errors"));
  setAccessibleDescription(tr("95 % of the errors are below %1 mm.").arg(error_95_mm_, 0, 'f', 3));
  rebuild();
}

QString HistogramPlot::empty_text() const {
  return tr("No errors to show yet");
}

void HistogramPlot::add_line(double x, const QString& text, Qt::Alignment side) {
  auto* line = new QCPItemLine(&chart());
  line->start->setCoords(x, 0);
  line->end->setCoords(x, chart().yAxis->range().upper);
  line->setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
  if (!text.isEmpty()) add_note(x, chart().yAxis->range().upper, text, side | Qt::AlignTop);
}

bool HistogramPlot::draw() {
  if (errors_mm_.empty()) return false;
  // Values beyond this count in the outermost bins.
  const double reach = std::max(2.2 * error_95_mm_, 1e-6);
  const double width = 2 * reach / kBins;
  std::vector<double> counts(kBins, 0.0);
  for (const double error : errors_mm_) {
    const double bin = std::floor((error + reach) / width);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))];
  }
  auto* bars = new QCPBars(chart().xAxis, chart().yAxis);
  bars->setWidth(width);
  bars->setPen(QPen(palette().color(QPalette::Base), 1));
  bars->setBrush(series_colour(0, palette()));
  double most = 0;
  for (int i = 0; i < kBins; ++i) {
    const double share =
        100.0 * counts[static_cast<std::size_t>(i)] / static_cast<double>(errors_mm_.size());
    bars->addData(-reach + (i + 0.5) * width, share);
    most = std::max(most, share);
  }
  chart().xAxis->setRange(-reach, reach);
  chart().yAxis->setRange(0, 1.25 * most);
  chart().xAxis->setLabel(axis_);
  chart().yAxis->setLabel(tr("Share of all blocks (%)"));
  add_line(-error_95_mm_, QString(), Qt::AlignRight);
  add_line(error_95_mm_, tr("95 % within\n± %1 mm").arg(error_95_mm_, 0, 'f', 3), Qt::AlignLeft);
  return true;
}

}  // namespace alltact
