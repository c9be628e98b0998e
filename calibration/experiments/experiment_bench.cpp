#include "calibration/experiments/experiment_bench.h"

#include "calibration/experiments/push_experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/force/new_force.h"
#include "calibration/reference/reference_recording.h"
#include "core/io/atomic_file.h"
#include "core/program.h"
#include "core/simulation/scene.h"
#include "core/sources/source.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr const char* kBenchRecording = "demo_reference";
constexpr const char* kBenchPresses = "demo_presses";
constexpr int kAtATime = 16;  // pictures that are rendered side by side and held in memory

/// finger: absent: as the file has it
Result<Plan> plan_of_scene(const std::string& name,
                           std::uint64_t seed,
                           const std::optional<DrawnFinger>& finger) {
  const auto file = find_resource(fmt::format("scenes/{}.yaml", name));
  if (!file) return file.error();
  const auto text = read_file(*file);
  if (!text) return text.error();
  const auto scene =
      finger ? scene_on_finger(*text, *file, *finger) : Scene::parse(*text, file->string());
  if (!scene) return scene.error();
  auto plan = Plan::compile(*scene, seed);
  if (!plan) return plan.error();
  if (const Status grey = plan->check_grey_levels(file->string()); !grey) return grey.error();
  return plan;
}

FramePtr frame_of_plan(const Plan& plan, int number) {
  auto frame = std::make_shared<Frame>();
  frame->grey = plan.render(number);
  frame->name = fmt::format("frame_{:05}", number);
  frame->sequence = static_cast<std::uint64_t>(number);
  frame->time_ns = std::llround(1e9 * (number + 1) / plan.frames_per_s());
  return frame;
}

std::vector<FramePtr> frames_of_plan(const Plan& plan, int first, int end, int threads) {
  std::vector<FramePtr> frames(static_cast<std::size_t>(end - first));
  const auto render = [&](const cv::Range& part) {
    for (int i = part.start; i < part.end; ++i)
      frames[static_cast<std::size_t>(i)] = frame_of_plan(plan, first + i);
  };
  const cv::Range all(0, end - first);
  if (threads > 1)
    cv::parallel_for_(all, render, threads);
  else
    render(all);
  return frames;
}

Error stopped_in_experiment() {
  return {en::say("stopped before the experiments were over"), "", ""};
}

/// A plan's frames, some of them rendered at a time.
class PlannedFrames : public Source {
 public:
  PlannedFrames(const Plan& plan, int threads, const Job& job)
      : plan_(plan), threads_(threads), job_(job) {}
  Result<FramePtr> next() override {
    if (job_.stop_requested()) return stopped_in_experiment();
    if (position_ == plan_.frame_count()) return FramePtr();
    const auto at = static_cast<std::size_t>(position_ % kAtATime);
    if (at == 0)
      ready_ = frames_of_plan(
          plan_, position_, std::min(plan_.frame_count(), position_ + kAtATime), threads_);
    ++position_;
    return std::move(ready_[at]);
  }
  std::optional<std::size_t> count() const override {
    return static_cast<std::size_t>(plan_.frame_count());
  }
  bool is_continuous() const override { return true; }
  double frames_per_s() const override { return plan_.frames_per_s(); }

 private:
  const Plan& plan_;
  const int threads_;
  const Job& job_;
  int position_ = 0;
  std::vector<FramePtr> ready_;
};

}  // namespace

Result<ExperimentBench::Recorded> ExperimentBench::record(const Plan& recording,
                                                          const std::string& folder,
                                                          const BenchOptions& options,
                                                          const Job& job) {
  Recorded made{recording.finger(), options.folder / folder, {}};
  made.finger.name = folder;
  std::error_code failed;  // made by earlier experiments, below a folder that is theirs
  std::filesystem::remove_all(made.folder, failed);
  if (const Status status = make_folder(made.folder); !status) return status.error();
  PlannedFrames source(recording, options.threads, job);
  const auto report = install_reference(source, made.folder, made.finger, job);
  if (!report) return report.error();
  if (const Status saved = made.finger.save(made.folder); !saved) return saved.error();
  made.truth_at_rest = recording.truth(report->rest_frame);
  return made;
}

Result<ExperimentBench> ExperimentBench::make(const BenchOptions& options, const Job& job) {
  ExperimentBench bench(options, job);
  const auto recording = bench.plan(kBenchRecording);
  if (!recording) return recording.error();
  auto recorded = record(*recording, options.name, options, job);
  if (!recorded) return recorded.error();
  bench.truth_at_rest_ = std::move(recorded->truth_at_rest);
  // Read once and held, so that the calibration and every pipeline share it.
  const auto uncalibrated = open_finger(recorded->folder);
  if (!uncalibrated) return uncalibrated.error();
  auto library = ReferenceLibrary::load(**uncalibrated, job);
  if (!library) return library.error();
  bench.library_ = std::move(*library);

  const auto presses = bench.plan(kBenchPresses);
  if (!presses) return presses.error();
  FingerCalibrationInput input;
  input.folder = recorded->folder;
  input.program_version = program_version();
  input.said.ball_radius_mm = presses->truth(0).ball.value().radius_mm;
  input.presses.frames = bench.frames(*presses, 0, presses->frame_count());
  const auto calibrated = calibrate_finger(input, job);
  if (!calibrated) return calibrated.error();
  auto finger = open_finger(recorded->folder);
  if (!finger) return finger.error();
  bench.finger_ = std::move(*finger);
  return bench;
}

Result<const ExperimentBench*> ExperimentBench::drawn_untaught(int number) const {
  auto& kept = untaught_[number];
  if (kept) return kept.get();
  BenchOptions options = options_;
  options.finger = DrawnFinger::draw(options.seed, number);
  options.name = fmt::format("{}_{}", options_.name, number);
  auto bench = make(options, job());
  if (!bench) return bench.error();
  kept = std::make_shared<const ExperimentBench>(std::move(*bench));
  return kept.get();
}

Result<const ExperimentBench::Drawn*> ExperimentBench::drawn(int number) const {
  auto& kept = drawn_[number];
  if (kept) return kept.get();
  const auto untaught = drawn_untaught(number);
  if (!untaught) return untaught.error();
  ExperimentBench bench = **untaught;
  auto table = table_of_pushes(bench, kForceScene, kForcePlaces);
  if (!table) return table.error();
  auto trained = bench.learn_force(*table, training_of_experiments());
  if (!trained) return trained.error();
  kept = std::make_shared<const Drawn>(
      Drawn{std::move(bench), std::move(*table), std::move(*trained)});
  return kept.get();
}

Result<TrainedForce> ExperimentBench::learn_force(const ForceTable& table,
                                                  const ForceTraining& training) {
  auto trained = give_force(finger_->folder, table, training, job());
  if (!trained) return trained.error();
  auto finger = open_finger(finger_->folder);
  if (!finger) return finger.error();
  finger_ = std::move(*finger);
  return trained;
}

Result<Plan> ExperimentBench::plan(const std::string& scene) const {
  return plan_of_scene(scene, options_.seed, options_.finger);
}

Result<Plan> ExperimentBench::plan_as_written(const std::string& scene) const {
  return plan_of_scene(scene, options_.seed, {});
}

std::vector<FramePtr> ExperimentBench::frames(const Plan& plan, int first, int end) const {
  return frames_of_plan(plan, first, end, options_.threads);
}

Result<int> ExperimentBench::measure(const std::string& scene,
                                     const std::vector<PipelineSettings>& settings,
                                     const Take& take,
                                     std::optional<double> room_level) const {
  assert(!settings.empty());
  DrawnFinger lit = options_.finger;
  lit.room_level = room_level;
  const auto scene_plan = plan_of_scene(scene, options_.seed, lit);
  if (!scene_plan) return scene_plan.error();
  std::vector<Pipeline> pipelines;
  for (const PipelineSettings& choice : settings) {
    auto pipeline = Pipeline::create(finger(), choice, job());
    if (!pipeline) return pipeline.error();
    pipelines.push_back(std::move(pipeline).value());
  }
  const int count = scene_plan->frame_count();
  std::vector<FramePtr> pictures;
  for (int number = 0; number < count; ++number) {
    if (job().stop_requested()) return stopped_in_experiment();
    job().report(static_cast<double>(number) / count,
                 en::say("{}: frame {} of {}", scene, number + 1, count));
    const auto at = static_cast<std::size_t>(number % kAtATime);
    if (at == 0) pictures = frames(*scene_plan, number, std::min(count, number + kAtATime));
    const FramePtr picture = std::move(pictures[at]);
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
