// Time of a frame's steps on this computer.
#include "calibration/experiments/experiment_runs.h"
#include "core/numerics/median.h"

#include <array>

namespace alltact {
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
      {en::say("whole frame, median"), "ms", upper_median(total_ms), 18.0, {}},
  };
  outcome.plots.push_back(compared_bars(
      en::say("time of a frame's steps, ours on this computer and the paper's on its own"),
      en::say("time (ms)"),
      {en::say("edges, shape"),
       en::say("markers, reference"),
       en::say("depth, contacts"),
       en::say("whole frame")},
      {upper_median(global_ms),
       upper_median(reference_ms),
       upper_median(local_ms),
       upper_median(total_ms)},
      {2, 10, 6, 18}));
  outcome.plots.back().series[0].name = en::say("ours, on this computer");
  outcome.remarks = {
      en::say("Times are of this computer, those of the paper of its own; the finger measures with "
              "the demonstration's mapping and 24 recorded poses")};
  return outcome;
}

}  // namespace alltact
