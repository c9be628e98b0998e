#include "calibration/experiments/simulated_world.h"

#include "calibration/experiments/experiment_bench.h"
#include "core/finger/reduced_finger.h"

#include <algorithm>

namespace alltact {
namespace {

constexpr const char* kStudyScene = "study_presses";
constexpr const char* kStudyBars = "experiment_pose";
constexpr int kFramesOfBar = 4;  // one bar is analysed for so many presses

Status add_bars(const ExperimentBench& bench, int frames, StudyWorld& world) {
  const auto plan = bench.plan(kStudyBars);
  if (!plan) return plan.error();
  const int count = std::clamp(frames / kFramesOfBar, 1, plan->frame_count());
  for (int i = 0; i < count; ++i) {
    const int number = i * plan->frame_count() / count;
    const Truth truth = plan->truth(number);
    StudyFrame frame;
    frame.image = bench.frames(*plan, number, number + 1).front();
    frame.depth_mm = truth.depth_mm;
    frame.angle_deg = truth.contacts.front().angle_deg.value();
    world.bars.push_back(std::move(frame));
  }
  return {};
}

}  // namespace

Result<StudyWorld> simulated_world(const std::filesystem::path& folder,
                                   const StudyWorldOptions& options,
                                   const Job& job) {
  BenchOptions bench_options;
  bench_options.folder = folder;
  bench_options.seed = options.seed;
  bench_options.threads = options.threads;
  const auto bench = ExperimentBench::make(bench_options, job);
  if (!bench) return bench.error();
  auto finger = open_finger(bench->finger().folder);
  if (!finger) return finger.error();
  auto library = ReferenceLibrary::load(**finger, job);
  if (!library) return library.error();
  const auto plan = bench->plan(kStudyScene);
  if (!plan) return plan.error();
  StudyWorld world{en::say("the demonstration's finger, simulated, pressed in random places"),
                   true,
                   std::move(finger).value(),
                   std::move(library).value(),
                   {},
                   0};
  world.library_for = [full_finger = world.finger](const PipelineSettings& settings,
                                                   const Job& doing) {
    return ReferenceLibrary::load(finger_as_measured(*full_finger, settings), doing);
  };
  const int count = std::min(options.frames, plan->frame_count());
  const std::vector<FramePtr> images = bench->frames(*plan, 0, count);
  for (int number = 0; number < count; ++number) {
    if (job.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
    Truth truth = plan->truth(number);
    const auto zone = zone_of_press(truth.depth_mm, truth.view_z_mm);
    if (!zone) continue;
    StudyFrame frame;
    frame.image = images[static_cast<std::size_t>(number)];
    frame.depth_mm = std::move(truth.depth_mm);
    frame.zone = *zone;
    if (truth.contacts.size() == 1)
      frame.position_mm.emplace(truth.contacts.front().along_mm, truth.contacts.front().across_mm);
    world.frames.push_back(std::move(frame));
  }
  if (const Status added = add_bars(*bench, options.frames, world); !added) return added.error();
  world.checksum = checksum_of(world.frames);
  return world;
}

}  // namespace alltact
