#include "calibration/experiments/experiment_bench.h"

#include "calibration/experiments/finger_cache.h"
#include "calibration/experiments/push_experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/force/finger_force_model.h"
#include "calibration/reference/reference_recording.h"
#include "core/io/atomic_file.h"
#include "core/numerics/parallel.h"
#include "core/program.h"
#include "core/simulation/scene.h"
#include "core/sources/source.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr const char* kBenchRecording = "demo_reference";
constexpr const char* kBenchPresses = "demo_presses";
constexpr int kBatchFrames = 16;  // images that are rendered in parallel and held in memory

struct SceneText {
  std::filesystem::path file;
  std::string text;
};

Result<SceneText> text_of_scene(const std::string& name) {
  const auto file = find_resource(fmt::format("scenes/{}.yaml", name));
  if (!file) return file.error();
  auto text = read_file(*file);
  if (!text) return text.error();
  return SceneText{*file, std::move(text).value()};
}

/// finger: nullopt: that of the file
Result<Plan> plan_of_scene(const std::string& name,
                           std::uint64_t seed,
                           const std::optional<FingerVariant>& finger) {
  const auto written = text_of_scene(name);
  if (!written) return written.error();
  const auto& [file, text] = *written;
  const auto scene =
      finger ? scene_on_finger(text, file, *finger) : Scene::parse(text, file.string());
  if (!scene) return scene.error();
  auto plan = Plan::compile(*scene, seed);
  if (!plan) return plan.error();
  if (const Status grey = plan->check_grey_levels(file.string()); !grey) return grey.error();
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

/// Every n-th frame of a plan within a range.
std::vector<FramePtr> frames_of_plan(const Plan& plan,
                                     const cv::Range& range,
                                     int every,
                                     int threads) {
  std::vector<FramePtr> frames(static_cast<std::size_t>(range.size()));
  parallel_for(range.size(), threads, [&](int first, int last) {
    for (int i = first; i < last; ++i)
      frames[static_cast<std::size_t>(i)] = frame_of_plan(plan, every * (range.start + i));
  });
  return frames;
}

/// A frame and its ground truth.
struct Shot {
  FramePtr image;
  Truth truth;
};

std::vector<Shot> shots_of_plan(const Plan& plan,
                                const cv::Range& range,
                                TruthDetail detail,
                                int threads) {
  std::vector<Shot> shots(static_cast<std::size_t>(range.size()));
  parallel_for(range.size(), threads, [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const int number = range.start + i;
      shots[static_cast<std::size_t>(i)] = {frame_of_plan(plan, number),
                                            plan.truth(number, detail)};
    }
  });
  return shots;
}

Error stopped_in_experiment() {
  return {en::say("stopped before the experiments were over"), "", ""};
}

/// Every n-th of a plan's frames, some of them rendered at a time.
class PlannedFrames : public Source {
 public:
  PlannedFrames(const Plan& plan, int every, int threads, const Job& job)
      : plan_(plan), every_(every), threads_(threads), job_(job) {
    assert(every > 0);
  }
  Result<FramePtr> next() override {
    if (job_.stop_requested()) return stopped_in_experiment();
    if (position_ == frame_count()) return FramePtr();
    const auto at = static_cast<std::size_t>(position_ % kBatchFrames);
    if (at == 0)
      ready_ = frames_of_plan(
          plan_, {position_, std::min(frame_count(), position_ + kBatchFrames)}, every_, threads_);
    ++position_;
    return std::move(ready_[at]);
  }
  std::optional<std::size_t> count() const override {
    return static_cast<std::size_t>(frame_count());
  }
  bool is_continuous() const override { return true; }
  double frames_per_s() const override { return plan_.frames_per_s() / every_; }

 private:
  [[nodiscard]] int frame_count() const { return (plan_.frame_count() + every_ - 1) / every_; }

  const Plan& plan_;
  const int every_, threads_;
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
  std::error_code failed;  // made by earlier experiments, below a folder of their own
  std::filesystem::remove_all(made.folder, failed);
  if (const Status status = make_folder(made.folder); !status) return status.error();
  PlannedFrames source(recording, options.recording_every, options.threads, job);
  const auto report = install_reference(source, made.folder, made.finger, job);
  if (!report) return report.error();
  if (const Status saved = made.finger.save(made.folder); !saved) return saved.error();
  made.rest_frame = options.recording_every * report->rest_frame;
  made.truth_at_rest = recording.truth(made.rest_frame, TruthDetail::kWithoutImages);
  return made;
}

Status ExperimentBench::make_finger(const Plan& recording) {
  auto recorded = record(recording, options_.name, options_, job());
  if (!recorded) return recorded.error();
  truth_at_rest_ = std::move(recorded->truth_at_rest);
  rest_frame_ = recorded->rest_frame;
  // Read once and held, so that the calibration and every pipeline share it.
  const auto uncalibrated = open_finger(recorded->folder);
  if (!uncalibrated) return uncalibrated.error();
  auto library = ReferenceLibrary::load(**uncalibrated, job());
  if (!library) return library.error();
  library_ = std::move(*library);

  const auto presses = plan(kBenchPresses);
  if (!presses) return presses.error();
  FingerCalibrationInput input;
  input.folder = recorded->folder;
  input.program_version = program_version();
  input.press_set.ball_radius_mm =
      presses->truth(0, TruthDetail::kWithoutImages).ball.value().radius_mm;
  input.presses.frames = frames(*presses, 0, presses->frame_count());
  const auto calibrated = calibrate_finger(input, job());
  if (!calibrated) return calibrated.error();
  auto finger = open_finger(recorded->folder);
  if (!finger) return finger.error();
  finger_ = std::move(*finger);
  return {};
}

/// Everything that the finger depends on: the scenes with its description, and the seed.
Result<std::string> ExperimentBench::cache_name() const {
  std::vector<std::string> made_by{
      options_.name, std::to_string(options_.seed), std::to_string(options_.recording_every)};
  for (const char* scene : {kBenchRecording, kBenchPresses}) {
    const auto written = text_of_scene(scene);
    if (!written) return written.error();
    auto text = scene_text_on_finger(written->text, written->file, options_.finger);
    if (!text) return text.error();
    made_by.push_back(std::move(text).value());
  }
  return cached_finger_name({made_by.begin(), made_by.end()});
}

bool ExperimentBench::restore_finger(const Plan& recording, const std::string& name) {
  const std::filesystem::path folder = options_.folder / options_.name;
  std::error_code failed;  // as in record()
  std::filesystem::remove_all(folder, failed);
  const auto note = load_cached_finger(*options_.cache, name, folder);
  if (!note) return false;
  const int rest_frame = std::atoi(note->c_str());
  auto finger = open_finger(folder);
  if (!finger || rest_frame < 0 || rest_frame >= recording.frame_count()) return false;
  auto library = ReferenceLibrary::load(**finger, job());
  if (!library) return false;
  finger_ = std::move(*finger);
  library_ = std::move(*library);
  rest_frame_ = rest_frame;
  truth_at_rest_ = recording.truth(rest_frame, TruthDetail::kWithoutImages);
  return true;
}

Result<ExperimentBench> ExperimentBench::make(const BenchOptions& options, const Job& job) {
  ExperimentBench bench(options, job);
  const auto recording = bench.plan(kBenchRecording);
  if (!recording) return recording.error();
  if (job.stop_requested()) return stopped_in_experiment();
  if (!options.cache) {
    const Status made = bench.make_finger(*recording);
    return made ? Result<ExperimentBench>(std::move(bench)) : made.error();
  }
  const auto name = bench.cache_name();
  if (!name) return name.error();
  bench.finger_was_cached_ = bench.restore_finger(*recording, *name);
  if (bench.finger_was_cached_) return bench;
  if (const Status made = bench.make_finger(*recording); !made) return made.error();
  const Status cached =
      cache_finger(*options.cache, *name, bench.finger_->folder, std::to_string(bench.rest_frame_));
  if (!cached) bench.cache_problem_ = cached.error();
  return bench;
}

Result<const ExperimentBench*> ExperimentBench::untrained_variant(int number) const {
  auto& cached = untrained_variants_[number];
  if (cached) return cached.get();
  BenchOptions options = options_;
  options.finger = FingerVariant::draw(options.seed, number);
  options.name = fmt::format("{}_{}", options_.name, number);
  auto bench = make(options, job());
  if (!bench) return bench.error();
  cached = std::make_shared<const ExperimentBench>(std::move(*bench));
  return cached.get();
}

Result<const ExperimentBench::TrainedVariant*> ExperimentBench::variant(int number) const {
  auto& cached = variants_[number];
  if (cached) return cached.get();
  const auto untaught = untrained_variant(number);
  if (!untaught) return untaught.error();
  ExperimentBench bench = **untaught;
  auto table = table_of_pushes(bench, kForceScene, kForcePositions);
  if (!table) return table.error();
  auto trained = bench.learn_force(*table, training_of_experiments());
  if (!trained) return trained.error();
  cached = std::make_shared<const TrainedVariant>(
      TrainedVariant{std::move(bench), std::move(*table), std::move(*trained)});
  return cached.get();
}

Result<TrainedForce> ExperimentBench::learn_force(const ForceTable& table,
                                                  const ForceTraining& training) {
  auto trained = train_finger_force(finger_->folder, table, training, job());
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
  return frames_of_plan(plan, {first, end}, 1, options_.threads);
}

Result<int> ExperimentBench::measure(const std::string& scene,
                                     const Measuring& measuring,
                                     const Take& take) const {
  assert(!measuring.settings.empty());
  FingerVariant lit = options_.finger;
  lit.room_level = measuring.room_level;
  const auto scene_plan = plan_of_scene(scene, options_.seed, lit);
  if (!scene_plan) return scene_plan.error();
  std::vector<Pipeline> pipelines;
  for (const PipelineSettings& choice : measuring.settings) {
    auto pipeline = Pipeline::create(finger(), choice, job());
    if (!pipeline) return pipeline.error();
    pipelines.push_back(std::move(pipeline).value());
  }
  const int count = scene_plan->frame_count();
  std::vector<Shot> shots;
  for (int number = 0; number < count; ++number) {
    if (job().stop_requested()) return stopped_in_experiment();
    job().report(static_cast<double>(number) / count,
                 en::say("{}: frame {} of {}", scene, number + 1, count));
    const auto at = static_cast<std::size_t>(number % kBatchFrames);
    if (at == 0)
      shots = shots_of_plan(*scene_plan,
                            {number, std::min(count, number + kBatchFrames)},
                            measuring.truth,
                            options_.threads);
    const Shot shot = std::move(shots[at]);
    for (std::size_t which = 0; which < pipelines.size(); ++which) {
      pipelines[which].forget();
      const auto result = pipelines[which](shot.image);
      if (!result) return result.error();
      take(which, shot.truth, *result);
    }
  }
  return count;
}

}  // namespace alltact
