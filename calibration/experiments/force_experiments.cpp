#include "calibration/experiments/force_experiments.h"

#include "calibration/experiments/experiments.h"
#include "calibration/force/collect_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

// Forces from the markers, cross-validated by entire groups.

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
  return {
      caption, en::say("true force (N)"), en::say("estimated force (N)"), {exact, estimated}, {}};
}

std::vector<ExperimentPlot> force_plots(const HeldOutForces& forces) {
  using Style = ExperimentSeries::Style;
  ExperimentPlot bars =
      compared_bars(en::say("mean error of the force, ours simulated and the paper's measured"),
                    en::say("mean error (N)"), {en::say("Fx"), en::say("Fy")},
                    {forces.error_N[0].mean(), forces.error_N[1].mean()}, {kPaperFx_N, kPaperFy_N});
  bars.series.push_back(level_line(en::say("target"), Style::kAim, kAimForce_N, -0.5, 1.5));
  ExperimentPlot along{
      en::say("error along the finger: pushes near the base move the markers least"),
      en::say("position along the finger (mm)"),
      en::say("mean error (N)"),
      {forces.errors_along(en::say("Fx, ours"), 0), forces.errors_along(en::say("Fy, ours"), 1)},
      {}};
  if (!along.series[0].x.empty()) {
    const double from = along.series[0].x.front(), to = along.series[0].x.back();
    along.series.push_back(
        level_line(en::say("Fx, paper, over all positions"), Style::kPaper, kPaperFx_N, from, to));
    along.series.push_back(
        level_line(en::say("Fy, paper, over all positions"), Style::kPaper, kPaperFy_N, from, to));
  }
  return {bars,
          estimated_against_true(en::say("Fx estimated at positions held out"),
                                 forces.estimated_by_true[0]),
          estimated_against_true(en::say("Fy estimated at positions held out"),
                                 forces.estimated_by_true[1]),
          along};
}

}  // namespace

ForceTraining training_of_experiments() {
  ForceTraining training;
  training.comparison_only = true;
  return training;
}

Result<ForceTable> table_of_pushes(const ExperimentBench& bench, const std::string& scene,
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
      {en::say("Fx, mean error at positions held out"), "N", error_N[0].mean(), kPaperFx_N,
       kAimForce_N},
      {en::say("Fy, mean error at positions held out"), "N", error_N[1].mean(), kPaperFy_N,
       kAimForce_N},
      {en::say("Fx, the same for the worst finger"), "N", held_out.worst_N[0], {}, {}},
      {en::say("Fy, the same for the worst finger"), "N", held_out.worst_N[1], {}, {}},
      {en::say("forces within their 95 % intervals"), "%", covered, {}, {}},
      {en::say("the same, deviation from 95 %"), "%", std::abs(covered - 95), {}, 2.0},
  };
  outcome.remarks = {
      en::say("{} fingers drawn at random, 484 pushes each at {} positions, some of which are held "
              "out entirely; {} pushes are measured, the others show too few markers. Forces act "
              "on the finger, in the camera's axes, without a gauge's error",
              kFingerVariants, kForcePositions, held_out.rows),
      en::say("No drag acts along the finger: it hardly moves a marker, so no marker shows it")};
  outcome.plots = force_plots(held_out);
  return outcome;
}

// Detection limits: depth on the contact face, and force on every face.

namespace {

constexpr double kPaperMin_N = 2.0;
constexpr double kBase_mm = 20;  // the paper's figure is for positions beyond

/// One trial: its strength, and whether it was detected.
struct ContactTrial {
  double strength;
  bool detected;
};

/// The least strength from which on all trials were detected; nullopt: not even the greatest.
std::optional<double> min_detected(const std::vector<ContactTrial>& trials) {
  double greatest_missed = -1;
  for (const ContactTrial& touch : trials)
    if (!touch.detected) greatest_missed = std::max(greatest_missed, touch.strength);
  std::optional<double> least;
  for (const ContactTrial& touch : trials)
    if (touch.strength > greatest_missed && (!least || touch.strength < *least))
      least = touch.strength;
  return least;
}

Message face_phrase(PushedFace face) {
  switch (face) {
    case PushedFace::kContact:
      return en::say("smallest force detected on the contact face, all heights");
    case PushedFace::kBack:
      return en::say("smallest force detected on the back, all heights");
    case PushedFace::kUpper:
      return en::say("smallest force detected on the upper side, all heights");
    case PushedFace::kLower:
      break;
  }
  return en::say("smallest force detected on the lower side, all heights");
}

/// Heights of the scene are 20 mm apart; a push slides along the face a little as the finger bends.
int height_of_mm(const ContactTruth& contact) {
  return 5 * static_cast<int>(std::lround(contact.along_mm / 5));
}

/// A frame of experiment_least_force.
struct PushedFrame {
  std::optional<ContactTruth> contact;
  std::optional<Markers> markers;
  bool base_at_low_u = true;
  bool has_region = false;
};

}  // namespace

Result<ExperimentOutcome> run_min_contact(const ExperimentBench& bench) {
  static constexpr const char* kScene = "experiment_least_touch";
  std::map<double, std::vector<ContactTrial>> by_height;
  const auto frames =
      bench.measure(kScene, {}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
        const ContactTruth& contact = truth.contacts.front();
        by_height[contact.along_mm].push_back({contact.depth_mm, !result.regions.empty()});
      });
  if (!frames) return frames.error();
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  for (const auto& [along_mm, trials] : by_height) {
    const auto least = min_detected(trials);
    if (!least) return no_result(kScene);
    outcome.figures.push_back(
        {en::say("smallest depth detected, {:.0f} mm from the base", along_mm),
         "mm",
         *least,
         {},
         {}});
  }
  ExperimentPlot plot{en::say("least detected depth of a ball, ours only"),
                      en::say("position along the finger (mm)"),
                      en::say("least detected depth (mm)"),
                      {{en::say("ours, simulated"), ExperimentSeries::Style::kLine, {}, {}}},
                      {}};
  for (const auto& [along_mm, trials] : by_height) {
    plot.series[0].x.push_back(along_mm);
    plot.series[0].y.push_back(min_detected(trials).value_or(0));
  }
  outcome.plots.push_back(std::move(plot));
  outcome.remarks = {en::say(
      "Depths double from 0.01 mm on, so that the smallest is between a value and its half")};
  return outcome;
}

Result<ExperimentOutcome> run_min_force(const ExperimentBench& bench) {
  static constexpr const char* kScene = "experiment_least_force";
  std::vector<PushedFrame> pushes;
  const auto frames =
      bench.measure(kScene, {}, [&](std::size_t, const Truth& truth, const FrameResult& result) {
        PushedFrame frame;
        if (!truth.contacts.empty()) frame.contact = truth.contacts.front();
        frame.markers = result.markers;
        frame.base_at_low_u = !result.shape || result.shape->base_at_low_u();
        frame.has_region = !result.regions.empty();
        pushes.push_back(std::move(frame));
      });
  if (!frames) return frames.error();
  // The dots' rest positions come from the frame in which nothing pushes. The recording's rest
  // frame is one of its poses, slightly bent.
  const auto free = std::find_if(pushes.begin(), pushes.end(),
                                 [](const PushedFrame& frame) { return !frame.contact; });
  if (free == pushes.end() || !free->markers) return no_result(kScene);
  ContactSettings rested = bench.finger().finger.contact.value_or(ContactSettings{});
  rested.rest_markers.clear();
  for (const Marker& marker : *free->markers) rested.rest_markers.emplace_back(marker.u, marker.v);

  std::map<PushedFace, std::map<int, std::vector<ContactTrial>>> trials;
  for (const PushedFrame& frame : pushes) {
    if (!frame.contact || frame.contact->along_mm < kBase_mm) continue;
    const bool pushed =
        frame.markers && push_of(*frame.markers, rested, frame.base_at_low_u).direction;
    trials[frame.contact->face][height_of_mm(*frame.contact)].push_back(
        {frame.contact->force_N.value().norm(), pushed || frame.has_region});
  }
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  ExperimentPlot plot{en::say("least detected force on every face, by height"),
                      en::say("position along the finger (mm)"),
                      en::say("least detected force (N)"),
                      {},
                      {},
                      true};
  for (const auto& [face, by_height] : trials) {
    double most_N = 0;
    ExperimentSeries felt_on{
        Message::typed(std::string(to_string(face))), ExperimentSeries::Style::kBars, {}, {}};
    if (plot.categories.empty())
      for (const auto& [along_mm, detected] : by_height)
        plot.categories.push_back(Message::typed(std::to_string(along_mm)));
    for (const auto& [along_mm, detected] : by_height) {
      const auto least = min_detected(detected);
      if (!least) return no_result(kScene);
      most_N = std::max(most_N, *least);
      felt_on.x.push_back(static_cast<double>(felt_on.x.size()));
      felt_on.y.push_back(*least);
    }
    plot.series.push_back(std::move(felt_on));
    outcome.figures.push_back({face_phrase(face), "N", most_N, kPaperMin_N, kPaperMin_N});
  }
  plot.series.push_back(level_line(en::say("paper, at most, measured"),
                                   ExperimentSeries::Style::kAim, kPaperMin_N, -0.6,
                                   static_cast<double>(plot.categories.size()) - 0.4));
  outcome.plots.push_back(std::move(plot));
  outcome.remarks = {
      en::say("All heights are beyond {:.0f} mm, where the paper reports less than 2 N; the body "
              "in the scene is rubber of Shore 40 A, the paper's silicone differs",
              kBase_mm)};
  return outcome;
}

}  // namespace alltact
