#include "calibration/study/study_figure.h"

#include "calibration/study/study_front.h"
#include "calibration/study/study_plot.h"

#include <algorithm>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr double kBudgetMs = 1000.0 / 30;

PlotDot dot_of(const AccuracyStudy& study, const StudyRow& row) {
  PlotDot dot;
  dot.x = frame_ms(study, row);
  dot.y = 1000 * row.depth->median_mm;
  dot.y95 = 1000 * row.depth->p95_mm;
  dot.words = fmt::format("{:.2f} ms, {:.1f} \u00b5m (95 % within {:.1f})", dot.x, dot.y, *dot.y95);
  if (row.position_mm) dot.words += fmt::format(", place {:.0f} \u00b5m", 1000 * *row.position_mm);
  if (row.real) {
    dot.real = 1000 * row.real->depth.median_mm;
    dot.real95 = 1000 * row.real->depth.p95_mm;
    dot.words += fmt::format(", real {:.1f} \u00b5m", *dot.real);
  }
  dot.words += ": " + words_of(row.settings, study.rows.front().settings).english();
  return dot;
}

}  // namespace

std::string svg_of(const AccuracyStudy& study) {
  StudyPlot plot;
  plot.title = "What accuracy costs in time";
  plot.subtitle =
      study.about.english() + (study.simulated ? " (simulated truth)" : " (painted truth)");
  plot.x_label = "time of a frame on this computer, ms";
  plot.y_label = "error of depth, micrometres";
  plot.budget = kBudgetMs;
  plot.budget_words = "30 pictures per second: 33.3 ms";
  if (study.rows.front().real) plot.real_label = "real: presses left out";
  const auto front = pareto_front(study);
  std::vector<std::size_t> dot_of_row(study.rows.size(), study.rows.size());
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    if (!study.rows[i].depth) continue;
    PlotDot dot = dot_of(study, study.rows[i]);
    dot.is_base = i == 0;
    dot.is_on_front = std::find(front.begin(), front.end(), i) != front.end();
    dot_of_row[i] = plot.dots.size();
    plot.dots.push_back(std::move(dot));
  }
  // First the choices with a preset name, then the rest of the front from its accurate end.
  const StudyPresets presets = presets_of(study);
  for (const auto& preset : {presets.fast, presets.finest})
    if (preset) plot.named.push_back(dot_of_row[*preset]);
  for (auto at = front.rbegin(); at != front.rend(); ++at) plot.named.push_back(dot_of_row[*at]);
  return svg_of(plot);
}

std::string svg_of(const CalibratingStudy& study) {
  StudyPlot plot;
  plot.title = "What a calibration costs and brings";
  plot.subtitle = study.about.english() + " (painted truth; minutes of hand are an estimate)";
  plot.x_label = "minutes of the technician and of this computer";
  plot.y_label = "error of depth, micrometres";
  if (study.no_real_reason.empty()) plot.real_label = "real: presses left out";
  const auto front = calibrating_front(study);
  std::vector<std::size_t> dot_of_row(study.rows.size(), study.rows.size());
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const CalibratingRow& row = study.rows[i];
    if (!row.painted) continue;
    PlotDot dot;
    dot.x = total_minutes(row);
    dot.y = 1000 * row.painted->median_mm;
    dot.y95 = 1000 * row.painted->p95_mm;
    dot.words = fmt::format("{:.1f} min, {:.1f} s computing, {:.1f} \u00b5m (95 % within {:.1f})",
                            dot.x,
                            row.computing_s,
                            dot.y,
                            *dot.y95);
    if (row.real) {
      dot.real = 1000 * row.real->depth.median_mm;
      dot.real95 = 1000 * row.real->depth.p95_mm;
      dot.words += fmt::format(", real {:.1f} \u00b5m", *dot.real);
    }
    dot.words += ": " + words_of(row.choice).english();
    dot.is_base = i == 0;
    dot.is_on_front = std::find(front.begin(), front.end(), i) != front.end();
    dot_of_row[i] = plot.dots.size();
    plot.dots.push_back(std::move(dot));
  }
  for (auto at = front.rbegin(); at != front.rend(); ++at) plot.named.push_back(dot_of_row[*at]);
  return svg_of(plot);
}

}  // namespace alltact
