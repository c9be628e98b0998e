// What one frame costs: the whole pipeline and its parts, each beside a copy of the same bytes.
#include "calibration/force/train_force.h"
#include "calibration/reference/reference_recording.h"
#include "core/finger/force_model.h"
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"
#include "core/sources/source.h"
#include "tests/support/plan_source.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

namespace alltact {
namespace {

constexpr int kReferenceFrames = 60, kForceRows = 120;

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at != std::string::npos) text.replace(at, from.size(), to);
}

/// The demonstration's finger at a picture scale of 1 (960x540) or 2 (1920x1080), with its library
/// and frames to measure, in each of which a ball presses the face.
struct Rig {
  Finger finger;
  std::vector<FramePtr> frames;
  std::vector<Truth> truths;  ///< of more frames than are measured
  test::TemporaryFolder folder;

  explicit Rig(int scale) {
    std::ifstream file(std::string(ALLTACT_SOURCE_DIR) + "/resources/scenes/demo_reference.yaml");
    std::stringstream text;
    text << file.rdbuf();
    std::string scene = text.str();
    if (scale == 2) {
      replace(scene, "[960, 540]", "[1920, 1080]");
      replace(scene, "fx: 523.9", "fx: 1047.8");
      replace(scene, "fy: 523.9", "fy: 1047.8");
      replace(scene, "cx: 479.5", "cx: 959.5");
      replace(scene, "cy: 269.5", "cy: 539.5");
    }
    const Plan plan = Plan::compile(Scene::parse(scene, "bench").value(), 5).value();
    replace(scene, "  - {use: markers,",
            "  - {use: ball, radius_mm: 4.0, s_mm: {from: 22.0, to: 80.0}, "
            "y_mm: {from: -4.0, to: 4.0}, depth_mm: {from: 0.4, to: 1.2}}\n"
            "  - {use: markers,");
    const Plan touched = Plan::compile(Scene::parse(scene, "bench").value(), 5).value();
    finger = plan.finger();
    PlanSource source(plan, kReferenceFrames);
    const auto report = install_reference(source, folder.path(), finger, Job());
    if (!report) throw std::runtime_error(report.error().sentence());
    MappingParameters mapping;
    mapping.kind = MappingKind::kMoebius;
    mapping.x_max = 0.6;
    mapping.a_mm = 2.4;
    mapping.b = 0.6;
    finger.mapping = mapping;
    PlanSource live(touched, 24);
    for (auto frame = live.next(); *frame; frame = live.next()) frames.push_back(*frame);
    for (int i = 0; i < kForceRows; ++i) truths.push_back(touched.truth(i));
  }
};

/// Made once: benchmarks are called again and again until they have run for long enough.
const Rig& rig_of(int scale) {
  static std::map<int, Rig> rigs;
  return rigs.try_emplace(scale, scale).first->second;
}

void whole_frame(benchmark::State& state, const PipelineSettings& settings) {
  cv::setNumThreads(1);
  const auto scale = static_cast<int>(state.range(0));
  const Rig& rig = rig_of(scale);
  auto pipeline =
      Pipeline::create(FingerSnapshot::of(rig.folder.path(), rig.finger).value(), settings, Job());
  if (!pipeline) {
    state.SkipWithError(pipeline.error().sentence().c_str());
    return;
  }
  std::size_t next = 0;
  StepTimes sum;
  double frames = 0;
  for ([[maybe_unused]] const auto _ : state) {
    // To and fro: a camera's frames follow each other.
    const std::size_t last = rig.frames.size() - 1, step = next++ % (2 * last);
    const auto result = (*pipeline)(rig.frames[step <= last ? step : 2 * last - step]);
    if (!result || !result->depth || result->regions.empty()) {
      state.SkipWithError("a frame showed no contact");
      return;
    }
    const StepTimes& t = result->times_ms;
    sum.edges += t.edges, sum.global += t.global, sum.markers += t.markers;
    sum.reference += t.reference, sum.local += t.local, sum.contact += t.contact;
    ++frames;
  }
  state.counters["edges_ms"] = sum.edges / frames;
  state.counters["global_ms"] = sum.global / frames;
  state.counters["markers_ms"] = sum.markers / frames;
  state.counters["reference_ms"] = sum.reference / frames;
  state.counters["local_ms"] = sum.local / frames;
  state.counters["contact_ms"] = sum.contact / frames;
}

void BM_WholeFrame(benchmark::State& state) { whole_frame(state, {}); }
void BM_WholeFrameNearest(benchmark::State& state) {
  PipelineSettings settings;
  settings.reference = ReferenceMethod::kNearest;
  whole_frame(state, settings);
}
/// markers_ms tells what each way of finding the markers costs.
void BM_WholeFramePaperMarkers(benchmark::State& state) {
  PipelineSettings settings;
  settings.marker_method = MarkerMethod::kPaper;
  whole_frame(state, settings);
}
void BM_WholeFrameNetworkMarkers(benchmark::State& state) {
  PipelineSettings settings;
  settings.marker_method = MarkerMethod::kNetwork;
  whole_frame(state, settings);
}

/// Of the processor, so that what else the computer does is not counted.
double processor_time_ms(Pipeline& pipeline, const FramePtr& frame, bool& told) {
  const std::clock_t begin = std::clock();
  const auto result = pipeline(frame);
  const std::clock_t end = std::clock();
  told = result && result->depth && !result->regions.empty() && result->contact && result->force;
  return 1e3 * static_cast<double>(end - begin) / CLOCKS_PER_SEC;
}

/// The dearest kind of model, learnt from forces that are in proportion to how the markers moved.
std::shared_ptr<const ForceModel> force_model_of(const Rig& rig) {
  ForceTable table;
  table.marker_count = rig.finger.marker_count();
  table.layouts.resize(kForceRows, 2 * table.marker_count);
  table.seen = Eigen::MatrixXd::Ones(kForceRows, table.marker_count);
  table.force_N.resize(kForceRows, table.axes);
  table.position_mm.resize(kForceRows, 2);
  for (Eigen::Index row = 0; row < kForceRows; ++row) {
    const Truth& truth = rig.truths[static_cast<std::size_t>(row)];
    for (Eigen::Index m = 0; m < table.marker_count; ++m) {
      const Truth::Dot& dot = truth.markers[static_cast<std::size_t>(m)];
      table.layouts.row(row).segment<2>(2 * m) << dot.u, dot.v;
    }
    for (Eigen::Index axis = 0; axis < table.axes; ++axis)
      table.force_N(row, axis) =
          0.01 * table.layouts(row, Eigen::seqN(axis, table.marker_count, 2)).sum();
    const ContactTruth& contact = truth.contacts.at(0);
    table.position_mm.row(row) << contact.along_mm, contact.across_mm;
    table.block.push_back(fmt::format("part {}", row / 20));
  }
  ForceTraining training;
  training.kind = ForceKind::kNetwork;
  training.comparison_only = true;
  auto trained = train_force(table, rig.finger.contact.value().rest_markers, training, Job());
  if (!trained) throw std::runtime_error(trained.error().sentence());
  return std::make_shared<const ForceModel>(std::move(trained->model));
}

/// What contact, pose, place and force add to a frame: each frame is measured with them and by a
/// pipeline that only tells depth, in turns within one run; of ten turns the best of each make a
/// pair. Of the pairs' differences come the median and what eight of ten lie between.
void contact_beside_none(benchmark::State& state) {
  cv::setNumThreads(1);
  constexpr int kTurns = 10;
  const Rig& rig = rig_of(static_cast<int>(state.range(0)));
  auto finger = FingerSnapshot::of(rig.folder.path(), rig.finger).value();
  finger.force = force_model_of(rig);
  auto with = Pipeline::create(finger, {}, Job());
  PipelineSettings nothing_touches;
  nothing_touches.contact_threshold_mm = 1.9;  // no region is as deep
  Finger unpushed = rig.finger;
  unpushed.contact.reset();  // no push is told either
  auto without = Pipeline::create(FingerSnapshot::of(rig.folder.path(), unpushed).value(),
                                  nothing_touches, Job());
  if (!with || !without) return state.SkipWithError("no pipeline");
  std::vector<double> more_ms, alone_ms;
  for ([[maybe_unused]] const auto _ : state)
    for (const FramePtr& frame : rig.frames) {
      double with_ms = std::numeric_limits<double>::max(), without_ms = with_ms;
      bool told = false, ignored = false;
      for (int turn = 0; turn < kTurns; ++turn) {
        with_ms = std::min(with_ms, processor_time_ms(*with, frame, told));
        without_ms = std::min(without_ms, processor_time_ms(*without, frame, ignored));
      }
      if (!told) return state.SkipWithError("a frame showed no contact");
      more_ms.push_back(with_ms - without_ms);
      alone_ms.push_back(without_ms);
    }
  std::sort(more_ms.begin(), more_ms.end());
  const auto at = [&](std::size_t percent) { return more_ms[more_ms.size() * percent / 100]; };
  state.counters["more_ms"] = at(50);
  double sum_ms = 0;
  for (const double ms : alone_ms) sum_ms += ms / static_cast<double>(alone_ms.size());
  state.counters["without_ms"] = sum_ms;
  state.counters["more_ms_p10"] = at(10);
  state.counters["more_ms_p90"] = at(90);
}

/// The bytes a frame cannot do without: the picture, its reference, the depth.
void BM_CopySameBytes(benchmark::State& state) {
  const auto scale = static_cast<std::size_t>(state.range(0));
  const std::size_t pixels = 960 * 540 * scale * scale;
  std::vector<std::uint8_t> from(pixels * (1 + 1 + 4), 7), to(from.size());
  for ([[maybe_unused]] const auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
}

BENCHMARK(BM_CopySameBytes)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WholeFrame)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(contact_beside_none)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(BM_WholeFrameNearest)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WholeFramePaperMarkers)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WholeFrameNetworkMarkers)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace alltact
