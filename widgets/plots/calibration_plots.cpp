#include "widgets/plots/calibration_plots.h"

#include "core/sensing/depth/depth_resolution.h"
#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alltact {

void MappingPlot::set_data(MappingPlotData data) {
  data_ = std::move(data);
  rebuild();
}

QString MappingPlot::title() const { return tr("Mapping from brightness to depth"); }

QString MappingPlot::empty_text() const {
  return tr("No mapping yet: calibrate with ball presses");
}

/// Plus and minus two standard deviations, below points and curve.
void MappingPlot::draw_band() {
  auto* low = chart().addGraph();
  auto* high = chart().addGraph();
  for (const auto& point : data_.curve) {
    low->addData(point.x, point.depth_mm - 2 * point.sd_mm);
    high->addData(point.x, point.depth_mm + 2 * point.sd_mm);
  }
  QColor colour = role_colour(ColourRole::kExpected, palette());
  low->setPen(Qt::NoPen);
  high->setPen(Qt::NoPen);
  colour.setAlpha(90);
  high->setBrush(colour);
  high->setChannelFillGraph(low);
  high->setName(tr("± 2 standard deviations"));
  low->removeFromLegend();
}

void MappingPlot::draw_points(bool certain, const QString& name) {
  auto* cloud = chart().addGraph();
  QColor colour = role_colour(certain ? ColourRole::kMeasured : ColourRole::kLeftOut, palette());
  colour.setAlpha(certain ? 170 : 120);
  cloud->setLineStyle(QCPGraph::lsNone);
  cloud->setScatterStyle(QCPScatterStyle(
      certain ? QCPScatterStyle::ssDisc : QCPScatterStyle::ssCross, colour, certain ? 3.0 : 4.0));
  for (const auto& point : data_.points)
    if (point.is_certain == certain) cloud->addData(point.x, point.depth_mm);
  cloud->setName(name);
  if (cloud->dataCount() == 0) chart().removeGraph(cloud);
}

void MappingPlot::draw_chosen() {
  auto* cloud = chart().addGraph();
  cloud->setLineStyle(QCPGraph::lsNone);
  cloud->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssPlus, palette().color(QPalette::Text), 5.0));
  for (const auto& point : data_.points)
    if (point.is_chosen) cloud->addData(point.x, point.depth_mm);
  cloud->setName(data_.chosen);
  if (cloud->dataCount() == 0) chart().removeGraph(cloud);
}

bool MappingPlot::draw() {
  if (data_.curve.empty()) return false;
  draw_band();
  draw_points(false, tr("nearer the rim"));
  draw_points(true, tr("inner part of a contact"));
  draw_chosen();
  auto* curve = chart().addGraph();
  for (const auto& point : data_.curve) curve->addData(point.x, point.depth_mm);
  curve->setPen(QPen(role_colour(ColourRole::kExpected, palette()), 2));
  curve->setName(tr("mapping"));

  double deepest = 0, darkest = data_.x_max;
  for (const auto& point : data_.curve) deepest = std::max(deepest, point.depth_mm);
  for (const auto& point : data_.points) {
    deepest = std::max(deepest, point.depth_mm);
    darkest = std::max(darkest, point.x);
  }
  chart().xAxis->setLabel(data_.is_small ? tr("Brightness difference x (no unit)")
                                         : tr("Brightness difference x (relative to untouched)"));
  chart().yAxis->setLabel(data_.is_small               ? tr("Depth (mm)")
                          : data_.depth_axis.isEmpty() ? tr("Press depth (mm)")
                                                       : data_.depth_axis);
  chart().xAxis->setRange(std::min(0.0, -0.02 * darkest), 1.06 * darkest);
  chart().yAxis->setRange(-0.04 * deepest, 1.12 * deepest);
  if (data_.x_max > 0) {
    auto* end = new QCPItemLine(&chart());
    end->start->setCoords(data_.x_max, chart().yAxis->range().lower);
    end->end->setCoords(data_.x_max, chart().yAxis->range().upper);
    end->setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
    if (!data_.is_small)
      add_note(data_.x_max, 0, tr("end of the calibrated range"), Qt::AlignRight | Qt::AlignBottom);
  }
  if (!data_.is_small) show_legend();
  return true;
}

namespace {

/// Labels 10⁻⁶ and 1 where the library writes 1E-06.
class PowersOfTen final : public QCPAxisTickerLog {
 protected:
  QString getTickLabel(double tick, const QLocale&, QChar, int) override {
    static const QString digits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    const int power = static_cast<int>(std::lround(std::log10(tick)));
    if (power == 0) return QStringLiteral("1");
    QString label = QStringLiteral("10");
    if (power < 0) label += QStringLiteral("⁻");
    for (const QChar digit : QString::number(std::abs(power))) label += digits[digit.digitValue()];
    return label;
  }
};

}  // namespace

ConvergencePlot::ConvergencePlot(QWidget* parent) : Plot(parent) {
  setAccessibleName(ConvergencePlot::title());
}

void ConvergencePlot::set_rounds(const std::vector<Round>& rounds) {
  if (rounds.size() == rounds_.size() && !rounds.empty()) return;  // rounds are only appended
  rounds_ = rounds;
  if (!rounds_.empty())
    setAccessibleDescription(
        tr("Residual after %n round(s): %1 mm.", "", static_cast<int>(rounds_.size()))
            .arg(QLocale().toString(rounds_.back().residual_mm, 'f', 4)));
  rebuild();
}

QString ConvergencePlot::title() const { return tr("Convergence of the solution"); }

QString ConvergencePlot::empty_text() const { return tr("Convergence has not started yet"); }

void ConvergencePlot::draw_residual() {
  auto* line = chart().addGraph();
  double most = 0;
  for (std::size_t i = 0; i < rounds_.size(); ++i) {
    line->addData(static_cast<double>(i + 1), rounds_[i].residual_mm);
    most = std::max(most, rounds_[i].residual_mm);
  }
  line->setName(tr("Residual"));
  line->setPen(QPen(role_colour(ColourRole::kMeasured, palette()), 2));
  line->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssDisc, role_colour(ColourRole::kMeasured, palette()), 6));
  chart().yAxis->setRange(0, most > 0 ? 1.25 * most : 1);
  chart().yAxis->setLabel(tr("Residual (mm)"));
}

void ConvergencePlot::draw_change() {
  constexpr double kNone = 1e-12;  // smaller changes are drawn as this
  QCPAxis& axis = *chart().yAxis2;
  auto* line = chart().addGraph(chart().xAxis, &axis);
  double least = 1, most = kNone;
  for (std::size_t i = 0; i < rounds_.size(); ++i) {
    const double change = std::max(rounds_[i].change_mm, kNone);
    line->addData(static_cast<double>(i + 1), change);
    least = std::min(least, change);
    most = std::max(most, change);
  }
  line->setName(tr("Change"));
  const QColor colour = series_colour(2, palette());
  line->setPen(QPen(colour, 2, Qt::DashLine));
  line->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssSquare, colour, 6));
  axis.setTicks(true);
  axis.setTickLabels(true);
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(QSharedPointer<PowersOfTen>::create());
  axis.setRange(std::pow(10, std::floor(std::log10(least))),
                std::pow(10, std::ceil(std::log10(most) + 0.5)));
  axis.setLabel(tr("Change of the unknowns (mm)"));
}

bool ConvergencePlot::draw() {
  if (rounds_.empty()) return false;
  draw_residual();
  draw_change();
  chart().xAxis->setRange(0.5, static_cast<double>(std::max<std::size_t>(rounds_.size(), 8)) + 0.5);
  auto integer_ticks = QSharedPointer<QCPAxisTickerFixed>::create();
  integer_ticks->setTickStep(1);
  integer_ticks->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  chart().xAxis->setTicker(integer_ticks);
  chart().xAxis->setLabel(tr("Round"));
  show_legend();
  return true;
}

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
  setAccessibleDescription(tr("95 % of the errors are below %1 mm.").arg(error_95_mm_, 0, 'f', 3));
  rebuild();
}

QString HistogramPlot::title() const { return tr("Distribution of errors"); }

QString HistogramPlot::empty_text() const { return tr("No errors to show yet"); }

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
  bars->setBrush(role_colour(ColourRole::kMeasured, palette()));
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

void ContrastPlot::set_data(std::vector<double> contrasts) {
  contrasts_ = std::move(contrasts);
  rebuild();
}

QString ContrastPlot::title() const { return tr("Contrast of fine relief"); }

QString ContrastPlot::empty_text() const { return tr("The resolution is not known"); }

bool ContrastPlot::draw() {
  if (contrasts_.empty()) return false;
  auto* line = chart().addGraph();
  double highest = 1;
  for (std::size_t i = 0; i < contrasts_.size(); ++i) {
    line->addData(DepthResolution::wave_per_mm(static_cast<int>(i)), contrasts_[i]);
    highest = std::max(highest, contrasts_[i]);
  }
  line->setPen(QPen(role_colour(ColourRole::kMeasured, palette()), 2));
  const double last = DepthResolution::wave_per_mm(static_cast<int>(contrasts_.size()) - 1);
  chart().xAxis->setLabel(tr("Waves per mm of the face"));
  chart().yAxis->setLabel(tr("Contrast of depth"));
  chart().xAxis->setRange(0, last);
  chart().yAxis->setRange(0, 1.08 * highest);
  constexpr double kHalf = 0.5;
  auto* half = new QCPItemLine(&chart());
  half->start->setCoords(0, kHalf);
  half->end->setCoords(last, kHalf);
  half->setPen(QPen(palette().color(QPalette::Text), 1, Qt::DashLine));
  add_note(last, kHalf, tr("half as deep as the skin"), Qt::AlignRight | Qt::AlignBottom);
  return true;
}

void HistoryPlot::set_data(HistoryData data) {
  data_ = std::move(data);
  std::stable_sort(data_.points.begin(), data_.points.end(),
                   [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
  rebuild();
}

QString HistoryPlot::title() const { return tr("Checks over time"); }

QString HistoryPlot::empty_text() const { return tr("Not checked yet since the calibration"); }

void HistoryPlot::draw_band(double from_mm, double to_mm, QColor colour, const QString& word) {
  if (!(to_mm > from_mm)) return;
  auto* band = new QCPItemRect(&chart());
  band->setLayer("background");
  band->topLeft->setCoords(chart().xAxis->range().lower, to_mm);
  band->bottomRight->setCoords(chart().xAxis->range().upper, from_mm);
  band->setPen(Qt::NoPen);
  add_note(chart().xAxis->range().upper, 0.5 * (from_mm + to_mm), word,
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
  draw_band(data_.drifting_above_mm, data_.recalibrate_above_mm,
            meaning_colour(Meaning::kDoubtful, palette()), tr("drifting"));
  draw_band(data_.recalibrate_above_mm, worst, meaning_colour(Meaning::kBad, palette()),
            tr("recalibrate"));

  auto* line = chart().addGraph();
  for (const auto& point : data_.points) line->addData(point.time_s, point.error_mm);
  line->setPen(QPen(role_colour(ColourRole::kMeasured, palette()), 2));
  line->setScatterStyle(
      QCPScatterStyle(QCPScatterStyle::ssDisc, role_colour(ColourRole::kMeasured, palette()), 7));
  QSharedPointer<QCPAxisTickerDateTime> dates(new QCPAxisTickerDateTime);
  dates->setDateTimeSpec(Qt::UTC);
  // In two lines: one would run into the next in a narrow column.
  constexpr double kDay_s = 86400;
  dates->setDateTimeFormat(last - first > 4 * kDay_s ? "yyyy\nMM-dd" : "MM-dd\nHH:mm");
  dates->setTickCount(2);  // at least: up to twice as many in a narrow column
  chart().xAxis->setTicker(dates);
  chart().xAxis->setLabel(tr("Time (UTC)"));
  chart().yAxis->setLabel(tr("Depth error (mm)"));
  return true;
}

}  // namespace alltact
