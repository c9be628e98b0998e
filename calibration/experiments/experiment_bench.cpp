#include "calibration/experiments/experiment_bench.h"

#include "calibration/finger/calibrate_finger.h"
#include "calibration/reference/reference_recording.h"
#include "core/io/atomic_file.h"
#include "core/program.h"
#include "core/simulation/scene.h"
#include "core/sources/open/open_source.h"

#include <cassert>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr const char* kBenchRecording = "demo_reference";
constexpr const char* kBenchPresses = "demo_presses";
constexpr const char* kBenchFinger = "experiment_finger";

Result<std::filesystem::path> scene_file(const std::string& scene) {
  return find_resource(fmt::format("scenes/{}.yaml", scene));
}

Result<Plan> plan_of_scene(const std::string& name, std::uint64_t seed) {
  const auto file = scene_file(name);
  if (!file) return file.error();
  const auto scene = Scene::load(*file);
  if (!scene) return scene.error();
  auto plan = Plan::compile(*scene, seed);
  if (!plan) return plan.error();
  if (const Status grey = plan->check_grey_levels(file->string()); !grey) return grey.error();
  return plan;
}

FramePtr frame_of_plan(const Plan& plan, int number, int threads) {
  auto frame = std::make_shared<Frame>();
  frame->grey = plan.render(number, threads);
  frame->name = fmt::format("frame_{:05}", number);
  frame->sequence = static_cast<std::uint64_t>(number);
  frame->time_ns = std::llround(1e9 * (number + 1) / plan.frames_per_s());
  return frame;
}

Error stopped_in_experiment() {
  return {en::say("stopped before the experiments were over"), "", ""};
}

}  // namespace

Result<ExperimentBench::Recorded> ExperimentBench::record(const std::string& recording,
                                                          const std::string& folder,
                                                          const BenchOptions& options,
                                                          const Job& job) {
  const auto plan = plan_of_scene(recording, options.seed);
  if (!plan) return plan.error();
  Recorded made{plan->finger(), options.folder / folder, {}};
  made.finger.name = folder;
  std::error_code failed;  // made by earlier experiments, below a folder that is theirs
  std::filesystem::remove_all(made.folder, failed);
  if (const Status status = make_folder(made.folder); !status) return status.error();
  SourceOptions how;
  how.seed = options.seed;
  how.threads = options.threads;
  how.job = &job;
  const auto file = scene_file(recording);
  if (!file) return file.error();
  auto source = open_source({*file}, how);
  if (!source) return source.error();
  const auto report = install_reference(**source, made.folder, made.finger, job);
  if (!report) return report.error();
  if (const Status saved = made.finger.save(made.folder); !saved) return saved.error();
  made.truth_at_rest = plan->truth(report->rest_frame);
  return made;
}

Result<ExperimentBench> ExperimentBench::make(const BenchOptions& options, const Job& job) {
  ExperimentBench bench(options, job);
  auto recorded = record(kBenchRecording, kBenchFinger, options, job);
  if (!recorded) return recorded.error();
  bench.truth_at_rest_ = std::move(recorded->truth_at_rest);

  const auto presses = plan_of_scene(kBenchPresses, options.seed);
  if (!presses) return presses.error();
  FingerCalibrationInput input;
  input.folder = recorded->folder;
  input.program_version = program_version();
  input.said.ball_radius_mm = presses->truth(0).ball.value().radius_mm;
  for (int number = 0; number < presses->frame_count(); ++number)
    input.presses.frames.push_back(frame_of_plan(*presses, number, options.threads));
  const auto calibrated = calibrate_finger(input, job);
  if (!calibrated) return calibrated.error();
  auto finger = open_finger(recorded->folder);
  if (!finger) return finger.error();
  bench.finger_ = std::move(*finger);
  auto library = ReferenceLibrary::load(bench.finger(), job);
  if (!library) return library.error();
  bench.library_ = std::move(*library);
  return bench;
}

Result<Plan> ExperimentBench::plan(const std::string& scene) const {
  return plan_of_scene(scene, options_.seed);
}

FramePtr ExperimentBench::frame(const Plan& plan, int number) const {
  return frame_of_plan(plan, number, options_.threads);
}

Result<int> ExperimentBench::measure(const std::string& scene,
                                     const std::vector<PipelineSettings>& settings,
                                     const Take& take) const {
  assert(!settings.empty());
  const auto scene_plan = plan(scene);
  if (!scene_plan) return scene_plan.error();
  std::vector<Pipeline> pipelines;
  for (const PipelineSettings& choice : settings) {
    auto pipeline = Pipeline::create(finger(), choice, job());
    if (!pipeline) return pipeline.error();
    pipelines.push_back(std::move(pipeline).value());
  }
  const int count = scene_plan->frame_count();
  for (int number = 0; number < count; ++number) {
    if (job().stop_requested()) return stopped_in_experiment();
    job().report(static_cast<double>(number) / count,
                 en::say("{}: frame {} of {}", scene, number + 1, count));
    const FramePtr picture = frame(*scene_plan, number);
    const Truth truth = scene_plan->truth(number);
    for (std::size_t which = 0; which < pipelines.size(); ++which) {
      pipelines[which].forget();
      const auto result = pipelines[which](picture);
      if (!result) return result.error();
      take(which, truth, *result);
    }
  }
  return count;
}

}  // namespace alltact
