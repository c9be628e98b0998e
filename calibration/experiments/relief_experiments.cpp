// Reliefs of things with edges, by our reference and by a single one.
#include "calibration/experiments/experiment_runs.h"
#include "calibration/study/evaluate.h"

#include <cmath>

namespace alltact {
namespace {

/// Straight as in the reference picture, or bent.
bool is_bent(const Truth& truth) {
  return std::any_of(truth.pose.begin(), truth.pose.end(), [](const auto& freedom) {
    return std::abs(freedom.second) > 1e-9;
  });
}

Result<ExperimentOutcome> relief_of(const ExperimentBench& bench, const std::string& scene) {
  PipelineSettings single;
  single.reference = ReferenceMethod::kSingle;
  // By method, straight and bent.
  std::vector<Evaluator> errors(4, Evaluator(bench.finger().camera));
  const auto frames =
      bench.measure(scene,
                    {PipelineSettings{}, single},
                    [&](std::size_t which, const Truth& truth, const FrameResult& result) {
                      Evaluator& here = errors[2 * which + (is_bent(truth) ? 1 : 0)];
                      if (!result.depth) return here.add_missing();
                      here.add(truth,
                               result.depth->depth_mm,
                               contact_face_points_mm(result, bench.finger().finger.face),
                               result.markers.value_or(Markers{}));
                    });
  if (!frames) return frames.error();
  const Message what[] = {en::say("relief, mean depth error, straight"),
                          en::say("relief, mean depth error, bent"),
                          en::say("the same straight, single reference"),
                          en::say("the same bent, single reference")};
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const auto mean = errors[i].evaluation().contact_depth_mm;
    if (!mean) return untold(scene);
    outcome.figures.push_back({what[i], "mm", *mean, {}, {}});
  }
  outcome.plots.push_back(
      compared_bars(en::say("error of the relief, ours alone: the paper shows pictures"),
                    en::say("mean depth error (mm)"),
                    {en::say("straight"),
                     en::say("bent"),
                     en::say("straight, one reference"),
                     en::say("bent, one reference")},
                    {outcome.figures[0].ours,
                     outcome.figures[1].ours,
                     outcome.figures[2].ours,
                     outcome.figures[3].ours},
                    {}));
  outcome.remarks = {en::say("The paper shows pictures of reliefs and no figure")};
  return outcome;
}

}  // namespace

Result<ExperimentOutcome> run_thread(const ExperimentBench& bench) {
  return relief_of(bench, "experiment_thread_m8");
}

Result<ExperimentOutcome> run_usb_plug(const ExperimentBench& bench) {
  return relief_of(bench, "experiment_usb_plug");
}

}  // namespace alltact
