// Forces from the markers, cross-validated by entire groups.
#include "calibration/experiments/push_experiments.h"

#include "calibration/experiments/experiment_runs.h"
#include "calibration/force/collect_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace alltact {
namespace {

/// Held-out rows of all fingers.
struct HeldOutForces {
  std::array<ErrorSamples, 2> error_N;
  std::array<double, 2> worst_N{};  ///< mean error of the worst finger
  std::array<ExperimentSeries, 2> estimated_by_true;
  std::array<std::map<std::string, ErrorSamples>, 2> by_position;
  std::map<std::string, ErrorSamples> position_mm;
  double covered = 0;  ///< within their intervals of 95 %
  int rows = 0;

  void add(const ForceTable& table, const TrainedForce& trained) {
    for (std::size_t a = 0; a < 2; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      ErrorSamples here;
      for (Eigen::Index row = 0; row < table.rows(); ++row) {
        const double truly = table.force_N(row, axis), estimated = trained.held_out_N(row, axis);
        here.add(std::abs(estimated - truly));
        error_N[a].add(std::abs(estimated - truly));
        by_position[a][table.block[static_cast<std::size_t>(row)]].add(std::abs(estimated - truly));
        estimated_by_true[a].x.push_back(truly);
        estimated_by_true[a].y.push_back(estimated);
      }
      worst_N[a] = std::max(worst_N[a], here.mean());
      covered += trained.covered_95[axis] * static_cast<double>(table.rows()) / 2;
    }
    for (Eigen::Index row = 0; row < table.rows(); ++row)
      if (table.has_position() && std::isfinite(table.position_mm(row, 0)))
        position_mm[table.block[static_cast<std::size_t>(row)]].add(table.position_mm(row, 0));
    rows += static_cast<int>(table.rows());
  }

  [[nodiscard]] ExperimentSeries errors_along(const Message& name, std::size_t axis) const {
    std::map<double, double> ordered;
    for (const auto& [position, errors] : by_position[axis])
      if (const auto where = position_mm.find(position); where != position_mm.end())
        ordered[where->second.mean()] = errors.mean();
    ExperimentSeries series{name, ExperimentSeries::Style::kLine, {}, {}};
    for (const auto& [along_mm, error] : ordered)
      series.x.push_back(along_mm), series.y.push_back(error);
    return series;
  }
};

constexpr double kPaperFx_N = 0.244, kPaperFy_N = 0.162, kAimForce_N = 0.1;

ExperimentPlot estimated_against_true(const Message& caption, ExperimentSeries estimated) {
  using Style = ExperimentSeries::Style;
  const auto [least, most] = std::minmax_element(estimated.x.begin(), estimated.x.end());
  const ExperimentSeries exact{
      en::say("no error"), Style::kExact, {*least, *most}, {*least, *most}};
  estimated.name = en::say("held out, ours, simulated");
  return {caption, en::say("true force (N)"), en::say("told force (N)"), {exact, estimated}, {}};
}

std::vector<ExperimentPlot> force_plots(const HeldOutForces& forces) {
  using Style = ExperimentSeries::Style;
  ExperimentPlot bars =
      compared_bars(en::say("mean error of the force, ours simulated and the paper's measured"),
                    en::say("mean error (N)"),
                    {en::say("Fx"), en::say("Fy")},
                    {forces.error_N[0].mean(), forces.error_N[1].mean()},
                    {kPaperFx_N, kPaperFy_N});
  bars.series.push_back(level_line(en::say("aim"), Style::kAim, kAimForce_N, -0.5, 1.5));
  ExperimentPlot along{
      en::say("where along the finger the error is: the base moves the markers least"),
      en::say("place along the finger (mm)"),
      en::say("mean error (N)"),
      {forces.errors_along(en::say("Fx, ours"), 0), forces.errors_along(en::say("Fy, ours"), 1)},
      {}};
  if (!along.series[0].x.empty()) {
    const double from = along.series[0].x.front(), to = along.series[0].x.back();
    along.series.push_back(
        level_line(en::say("Fx, paper, over all places"), Style::kPaper, kPaperFx_N, from, to));
    along.series.push_back(
        level_line(en::say("Fy, paper, over all places"), Style::kPaper, kPaperFy_N, from, to));
  }
  return {bars,
          estimated_against_true(en::say("Fx told of places that were held out"),
                                 forces.estimated_by_true[0]),
          estimated_against_true(en::say("Fy told of places that were held out"),
                                 forces.estimated_by_true[1]),
          along};
}

}  // namespace

ForceTraining training_of_experiments() {
  ForceTraining training;
  training.comparison_only = true;
  return training;
}

Result<ForceTable> table_of_pushes(const ExperimentBench& bench,
                                   const std::string& scene,
                                   int positions) {
  std::vector<MarkerFrame> frames;
  ForceGauge gauge;
  gauge.has_block = true;
  int number = 0;
  const auto measured =
      bench.measure(scene, {}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
        const int position = number++ % positions;
        if (!result.markers || truth.contacts.empty()) return;
        std::optional<Eigen::Vector2d> position_mm;
        if (!result.regions.empty()) position_mm = result.regions.front().position_on_face_mm;
        frames.push_back({result.frame->name, std::nullopt, *result.markers, position_mm});
        GaugeReading reading;
        reading.frame = result.frame->name;
        reading.force_N = truth.contacts.front().force_N.value();
        reading.block = fmt::format("place {}", position);
        gauge.readings.push_back(std::move(reading));
      });
  if (!measured) return measured.error();
  auto collected = collect_force(frames, gauge);
  if (!collected) return collected.error();
  return std::move(collected->table);
}

Result<ExperimentOutcome> run_force(const ExperimentBench& bench) {
  HeldOutForces held_out;
  for (int number = 1; number <= kFingerVariants; ++number) {
    const auto variant = bench.variant(number);
    if (!variant) return variant.error();
    held_out.add((*variant)->table, (*variant)->trained);
  }
  const auto& error_N = held_out.error_N;
  const double covered = 100 * held_out.covered / held_out.rows;
  ExperimentOutcome outcome;
  outcome.frames = held_out.rows;
  outcome.figures = {
      {en::say("Fx, mean error on places held out"),
       "N",
       error_N[0].mean(),
       kPaperFx_N,
       kAimForce_N},
      {en::say("Fy, mean error on places held out"),
       "N",
       error_N[1].mean(),
       kPaperFy_N,
       kAimForce_N},
      {en::say("Fx, the same of the worst finger"), "N", held_out.worst_N[0], {}, {}},
      {en::say("Fy, the same of the worst finger"), "N", held_out.worst_N[1], {}, {}},
      {en::say("forces within their intervals of 95 %"), "%", covered, {}, {}},
      {en::say("the same, away from 95 %"), "%", std::abs(covered - 95), {}, 2.0},
  };
  outcome.remarks = {
      en::say("{} fingers drawn at random, 484 pushes each at {} places, of which whole ones are "
              "held out; {} pushes are measured, in the others too few markers are found. Forces "
              "are those on the finger in the camera's axes and have no error of a gauge",
              kFingerVariants,
              kForcePositions,
              held_out.rows),
      en::say("Nothing drags along the finger: that hardly moves a marker, and is told by none")};
  outcome.plots = force_plots(held_out);
  return outcome;
}

}  // namespace alltact
