#include "widgets/plots/experiment_figure.h"

#include "widgets/plots/custom_plot.h"
#include "widgets/theme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

using Look = ExperimentSeries::Look;

QString words_of(const Message& message) {
  return QString::fromStdString(message.english());
}

/// With room behind: a legend in a sharp picture is cut off a little too early.
QString legend_words(const Message& message) {
  return words_of(message) + QStringLiteral("    ");
}

constexpr std::size_t kPointsToMark = 30;  // of a line; more hide it

bool is_bar(const ExperimentPlot& plot, const ExperimentSeries& series) {
  return !plot.categories.empty() && (series.look == Look::kBars || series.look == Look::kPaper);
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
  // Above the plot, where it hides nothing.
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
  constexpr double kTogether = 0.7;  // of the way from one to the next
  const bool is_paper = series.look == Look::kPaper;
  auto* bars = new QCPBars(chart().xAxis, chart().yAxis);
  const double width = kTogether / of;
  bars->setWidth(0.92 * width);
  if (plot_.logarithmic_y) bars->setBaseValue(least_shown_);
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
    curve->addData(series.x[i], std::max(series.y[i], least_shown_));
  const QColor colour = series_colour(which, palette());
  const QColor text = palette().color(QPalette::Text);
  switch (series.look) {
    case Look::kPaper:
      curve->setPen(QPen(colour, 2, Qt::DashLine));
      if (series.x.size() == 1) curve->setScatterStyle(mark_of(which, colour, 12));
      break;
    case Look::kAim:
      curve->setPen(QPen(text, 1.5, Qt::DotLine));
      break;
    case Look::kExact:
      curve->setPen(QPen(text, 1));
      break;
    case Look::kLine:
      curve->setPen(QPen(colour, 2));
      if (series.x.size() <= kPointsToMark) curve->setScatterStyle(mark_of(which, colour));
      break;
    case Look::kDots:
    case Look::kBars:
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
  least_ = {kInfinite, kInfinite}, most_ = {-kInfinite, -kInfinite};
  double least_above_0 = kInfinite;
  for (const ExperimentSeries& series : plot_.series) {
    for (const double x : series.x)
      least_.rx() = std::min(least_.x(), x), most_.rx() = std::max(most_.x(), x);
    for (const double y : series.y) {
      least_.ry() = std::min(least_.y(), y), most_.ry() = std::max(most_.y(), y);
      if (y > 0) least_above_0 = std::min(least_above_0, y);
    }
  }
  least_shown_ = -kInfinite;
  if (!plot_.logarithmic_y) return;
  // The power of ten below; an error of exactly 0 stands on the axis.
  least_shown_ = std::pow(10, std::floor(std::log10(0.9 * std::min(least_above_0, 1e9))));
}

void ExperimentFigurePlot::set_ranges() {
  if (plot_.logarithmic_y) {
    chart().yAxis->setScaleType(QCPAxis::stLogarithmic);
    chart().yAxis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    chart().yAxis->setNumberFormat("g");
    chart().yAxis->setNumberPrecision(3);
    chart().yAxis->setRange(least_shown_, 1.6 * std::max(most_.y(), 2 * least_shown_));
  } else {
    // Errors and shares begin at 0; what has a sign lies around it.
    const double low = std::min(least_.y(), 0.0);
    const double height = std::max(most_.y() - low, 1e-9);
    chart().yAxis->setRange(low < 0 ? low - 0.06 * height : 0, most_.y() + 0.08 * height);
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
  const double margin = 0.04 * std::max(most_.x() - least_.x(), 1e-9);
  chart().xAxis->setRange(least_.x() - margin, most_.x() + margin);
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
