#include "calibration/experiments/experiments.h"

#include "core/base/message.h"
#include "core/numerics/median.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace alltact {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      {"localisation",
       en::say("contact position, at 9 x 3 points of the face"),
       {"experiment_localisation"},
       run_localisation},
      {"pose", en::say("rotation of a held bar"), {"experiment_pose"}, run_pose},
      {"least-touch",
       en::say("smallest detectable depth of a ball"),
       {"experiment_least_touch"},
       run_min_contact},
      {"least-force",
       en::say("smallest detectable force on every face"),
       {"experiment_least_force"},
       run_min_force},
      {"direction",
       en::say("push direction, one of 8 sides"),
       {"experiment_direction", "experiment_references"},
       run_direction},
      {"force",
       en::say("Fx and Fy of pushes, on fingers drawn at random"),
       {"experiment_force"},
       run_force},
      {"references",
       en::say("one untouched image against a recording of all poses"),
       {"experiment_references"},
       run_references},
      {"room-light",
       en::say("position and force in rooms of 300, 1100 and 2500 lux"),
       {"experiment_room_light", "experiment_room_force", "experiment_force"},
       run_room_light},
      {"thread",
       en::say("relief of an M8 thread, against a single reference"),
       {"experiment_thread_m8"},
       run_thread},
      {"usb-plug",
       en::say("relief of a USB plug, against a single reference"),
       {"experiment_usb_plug"},
       run_usb_plug},
      {"markers",
       en::say("what the methods of finding markers cost and gain"),
       {"demo_presses", "hard_hidden_dots", "hard_worn_dots", "hard_defocus_at_the_base",
        "hard_defocus_at_the_tip", "hard_dead_lamp", "hard_dirty_skin"},
       run_markers},
      {"time",
       en::say("time for each step of a frame, full HD with 24 dots"),
       {"experiment_time", "demo_hd_reference"},
       run_time},
  };
  return all;
}

Message simulated_and_real() {
  return en::say(
      "Our values are simulated, with known truth; the paper's were measured on a real finger.");
}

Result<std::vector<const Experiment*>> experiments_named(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const Experiment& experiment : experiments()) known.push_back(experiment.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      return Error{en::say("there is no experiment '{}'", name), "", one_of(known, name)};
  std::vector<const Experiment*> chosen;
  for (const Experiment& experiment : experiments())
    if (names.empty() || std::find(names.begin(), names.end(), experiment.name) != names.end())
      chosen.push_back(&experiment);
  return chosen;
}

namespace {

ExperimentSeries bars(const Message& name, ExperimentSeries::Style style, std::vector<double> y) {
  std::vector<double> x(y.size());
  std::iota(x.begin(), x.end(), 0.0);
  return {name, style, std::move(x), std::move(y)};
}

}  // namespace

ExperimentPlot compared_bars(const Message& caption, const Message& y_axis,
                             std::vector<Message> categories, std::vector<double> simulated,
                             std::vector<double> paper) {
  using Style = ExperimentSeries::Style;
  ExperimentPlot plot{caption, "", y_axis, {}, std::move(categories)};
  plot.series.push_back(bars(en::say("ours, simulated"), Style::kBars, std::move(simulated)));
  if (!paper.empty())
    plot.series.push_back(bars(en::say("paper, measured"), Style::kPaper, std::move(paper)));
  return plot;
}

ExperimentSeries level_line(const Message& name, ExperimentSeries::Style style, double y,
                            double from_x, double to_x) {
  return {name, style, {from_x, to_x}, {y, y}};
}

// Time of a frame's steps on this computer.

namespace {

constexpr int kRounds = 6;  // through the scene; the first one warms up

}  // namespace

Result<ExperimentOutcome> run_time(const ExperimentBench& bench) {
  const auto plan = bench.plan_as_written("experiment_time");
  if (!plan) return plan.error();
  const auto recording = bench.plan_as_written("demo_hd_reference");
  if (!recording) return recording.error();
  auto recorded =
      ExperimentBench::record(*recording, "experiment_hd_finger", bench.options(), bench.job());
  if (!recorded) return recorded.error();
  // A mapping depends on layer and light, not on pixels.
  recorded->finger.mapping = bench.finger().finger.mapping;
  const auto finger = FingerSnapshot::of(recorded->folder, recorded->finger);
  if (!finger) return finger.error();
  auto pipeline = Pipeline::create(*finger, PipelineSettings{}, bench.job());
  if (!pipeline) return pipeline.error();

  const std::vector<FramePtr> images = bench.frames(*plan, 0, plan->frame_count());
  std::vector<double> global_ms, reference_ms, local_ms, total_ms;
  int measured = 0;
  for (int round = 0; round < kRounds; ++round)
    for (const FramePtr& image : images) {
      const auto result = (*pipeline)(image);
      if (!result) return result.error();
      if (round == 0 || !result->depth) continue;
      const StepTimes& ms = result->times_ms;
      global_ms.push_back(ms.prepare + ms.edges + ms.global);
      reference_ms.push_back(ms.markers + ms.reference);
      local_ms.push_back(ms.local + ms.contact);
      total_ms.push_back(ms.total);
      ++measured;
    }
  if (measured == 0) return no_result("experiment_time");
  ExperimentOutcome outcome;
  outcome.frames = measured;
  outcome.figures = {
      {en::say("edges and global shape, median"), "ms", upper_median(global_ms), 2.0, {}},
      {en::say("markers and reference, median"), "ms", upper_median(reference_ms), 10.0, {}},
      {en::say("local depth and contacts, median"), "ms", upper_median(local_ms), 6.0, {}},
      {en::say("entire frame, median"), "ms", upper_median(total_ms), 18.0, {}},
  };
  outcome.plots.push_back(compared_bars(
      en::say("time of a frame's steps, ours on this computer and the paper's on its own"),
      en::say("time (ms)"),
      {en::say("edges, shape"), en::say("markers, reference"), en::say("depth, contacts"),
       en::say("entire frame")},
      {upper_median(global_ms), upper_median(reference_ms), upper_median(local_ms),
       upper_median(total_ms)},
      {2, 10, 6, 18}));
  outcome.plots.back().series[0].name = en::say("ours, on this computer");
  outcome.remarks = {
      en::say("Times were measured on this computer, those of the paper on its own; the finger "
              "uses the demonstration's mapping and 24 recorded poses")};
  return outcome;
}

}  // namespace alltact
