#include "calibration/experiments/experiment_plot.h"

#include <numeric>

namespace alltact {
namespace {

ExperimentSeries bars(const Message& name, ExperimentSeries::Style style, std::vector<double> y) {
  std::vector<double> x(y.size());
  std::iota(x.begin(), x.end(), 0.0);
  return {name, style, std::move(x), std::move(y)};
}

}  // namespace

ExperimentPlot compared_bars(const Message& caption,
                             const Message& y_axis,
                             std::vector<Message> categories,
                             std::vector<double> simulated,
                             std::vector<double> paper) {
  using Style = ExperimentSeries::Style;
  ExperimentPlot plot{caption, "", y_axis, {}, std::move(categories)};
  plot.series.push_back(bars(en::say("ours, simulated"), Style::kBars, std::move(simulated)));
  if (!paper.empty())
    plot.series.push_back(bars(en::say("paper, measured"), Style::kPaper, std::move(paper)));
  return plot;
}

ExperimentSeries level_line(
    const Message& name, ExperimentSeries::Style style, double y, double from_x, double to_x) {
  return {name, style, {from_x, to_x}, {y, y}};
}

}  // namespace alltact
