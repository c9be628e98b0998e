#include "widgets/plots/experiment_figure.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

using Style = ExperimentSeries::Style;

QString words_of(const Message& message) {
  return QString::fromStdString(message.english());
}

/// With spaces behind: in a high-resolution image QCustomPlot clips the legend a little too early.
QString legend_words(const Message& message) {
  return words_of(message) + QStringLiteral("    ");
}

constexpr std::size_t kPointsToMark = 30;  // on a line; with more points no markers are drawn

bool is_bar(const ExperimentPlot& plot, const ExperimentSeries& series) {
  return !plot.categories.empty() &&
         (series.style == Style::kBars || series.style == Style::kPaper);
}

QCPScatterStyle mark_of(int which, const QColor& colour, double size = 6) {
  constexpr QCPScatterStyle::ScatterShape kShapes[] = {QCPScatterStyle::ssDisc,
                                                       QCPScatterStyle::ssSquare,
                                                       QCPScatterStyle::ssTriangle,
                                                       QCPScatterStyle::ssDiamond};
  return {kShapes[which % 4], QPen(colour, 1.5), QBrush(colour), size};
}

}  // namespace

ExperimentFigurePlot::ExperimentFigurePlot(QWidget* parent) : Plot(parent) {
  setAccessibleName(tr("Figure of an experiment"));
  // Above the plot, so that it covers no data.
  constexpr int kSideBySide = 2;
  QCPLegend* legend = chart().legend;
  chart().axisRect()->insetLayout()->take(legend);
  chart().plotLayout()->insertRow(0);
  chart().plotLayout()->addElement(0, 0, legend);
  chart().plotLayout()->setRowStretchFactor(0, 0.001);
  legend->setFillOrder(QCPLegend::foColumnsFirst);
  legend->setWrap(kSideBySide);
}

void ExperimentFigurePlot::set_plot(const ExperimentPlot& plot) {
  plot_ = plot;
  setAccessibleDescription(words_of(plot_.caption));
  rebuild();
}

QString ExperimentFigurePlot::empty_text() const {
  return tr("Nothing was measured");
}

void ExperimentFigurePlot::draw_bars(const ExperimentSeries& series, int which, int of) {
  constexpr double kTogether = 0.7;  // fraction of the distance between two groups
  const bool is_paper = series.style == Style::kPaper;
  auto* bars = new QCPBars(chart().xAxis, chart().yAxis);
  const double width = kTogether / of;
  bars->setWidth(0.92 * width);
  if (plot_.logarithmic_y) bars->setBaseValue(min_shown_);
  for (std::size_t i = 0; i < series.x.size(); ++i)
    bars->addData(series.x[i] + (which - 0.5 * (of - 1)) * width, series.y[i]);
  const QColor colour = series_colour(which, palette());
  bars->setPen(QPen(colour, 1.5));
  bars->setBrush(is_paper ? QBrush(colour, Qt::BDiagPattern) : QBrush(colour));
  bars->setName(legend_words(series.name));
}

void ExperimentFigurePlot::draw_points(const ExperimentSeries& series, int which) {
  auto* curve = new QCPCurve(chart().xAxis, chart().yAxis);
  for (std::size_t i = 0; i < series.x.size(); ++i)
    curve->addData(series.x[i], std::max(series.y[i], min_shown_));
  const QColor colour = series_colour(which, palette());
  const QColor text = palette().color(QPalette::Text);
  switch (series.style) {
    case Style::kPaper:
      curve->setPen(QPen(colour, 2, Qt::DashLine));
      if (series.x.size() == 1) curve->setScatterStyle(mark_of(which, colour, 12));
      break;
    case Style::kAim:
      curve->setPen(QPen(text, 1.5, Qt::DotLine));
      break;
    case Style::kExact:
      curve->setPen(QPen(text, 1));
      break;
    case Style::kLine:
      curve->setPen(QPen(colour, 2));
      if (series.x.size() <= kPointsToMark) curve->setScatterStyle(mark_of(which, colour));
      break;
    case Style::kDots:
    case Style::kBars:
      curve->setPen(Qt::NoPen);
      curve->setScatterStyle(series.x.size() > 200
                                 ? QCPScatterStyle(QCPScatterStyle::ssDisc, colour, 3)
                                 : mark_of(which, colour));
      break;
  }
  curve->setName(legend_words(series.name));
}

void ExperimentFigurePlot::find_extent() {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  min_ = {kInfinite, kInfinite}, max_ = {-kInfinite, -kInfinite};
  double min_above_0 = kInfinite;
  for (const ExperimentSeries& series : plot_.series) {
    for (const double x : series.x)
      min_.rx() = std::min(min_.x(), x), max_.rx() = std::max(max_.x(), x);
    for (const double y : series.y) {
      min_.ry() = std::min(min_.y(), y), max_.ry() = std::max(max_.y(), y);
      if (y > 0) min_above_0 = std::min(min_above_0, y);
    }
  }
  min_shown_ = -kInfinite;
  if (!plot_.logarithmic_y) return;
  // The power of ten below the smallest value; an error of exactly 0 stands on the axis.
  min_shown_ = std::pow(10, std::floor(std::log10(0.9 * std::min(min_above_0, 1e9))));
}

void ExperimentFigurePlot::set_ranges() {
  if (plot_.logarithmic_y) {
    chart().yAxis->setScaleType(QCPAxis::stLogarithmic);
    chart().yAxis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    chart().yAxis->setNumberFormat("g");
    chart().yAxis->setNumberPrecision(3);
    chart().yAxis->setRange(min_shown_, 1.6 * std::max(max_.y(), 2 * min_shown_));
  } else {
    // Errors and fractions begin at 0; signed values lie around it.
    const double low = std::min(min_.y(), 0.0);
    const double height = std::max(max_.y() - low, 1e-9);
    chart().yAxis->setRange(low < 0 ? low - 0.06 * height : 0, max_.y() + 0.08 * height);
  }
  if (!plot_.categories.empty()) {
    chart().xAxis->setRange(-0.6, static_cast<double>(plot_.categories.size()) - 0.4);
    auto names = QSharedPointer<QCPAxisTickerText>::create();
    for (std::size_t i = 0; i < plot_.categories.size(); ++i)
      names->addTick(static_cast<double>(i), words_of(plot_.categories[i]));
    chart().xAxis->setTicker(names);
    chart().xAxis->grid()->setVisible(false);
    return;
  }
  const double margin = 0.04 * std::max(max_.x() - min_.x(), 1e-9);
  chart().xAxis->setRange(min_.x() - margin, max_.x() + margin);
}

bool ExperimentFigurePlot::draw() {
  if (plot_.series.empty()) return false;
  const auto bars = static_cast<int>(
      std::count_if(plot_.series.begin(), plot_.series.end(), [&](const auto& one) {
        return is_bar(plot_, one);
      }));
  find_extent();
  int which = 0;
  for (const ExperimentSeries& series : plot_.series) {
    if (is_bar(plot_, series))
      draw_bars(series, which, bars);
    else
      draw_points(series, which);
    ++which;
  }
  set_ranges();
  chart().xAxis->setLabel(words_of(plot_.x_axis));
  chart().yAxis->setLabel(words_of(plot_.y_axis));
  chart().legend->setVisible(true);
  return true;
}

}  // namespace alltact
