#include "calibration/experiments/simulating_study.h"

#include "calibration/experiments/experiment_bench.h"
#include "calibration/study/evaluate.h"
#include "calibration/study/real_presses.h"
#include "calibration/study/study_machine.h"
#include "calibration/study/study_plot.h"
#include "calibration/study/study_world.h"
#include "core/base/atomic_file.h"
#include "core/base/yaml.h"
#include "core/finger/finger_store.h"
#include "core/numerics/median.h"
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

/// The text of a scene without one of its effects, and the effects' names in the file.
class EditedScene {
 public:
  static Result<EditedScene> read(const std::filesystem::path& file) {
    auto text = read_file(file);
    if (!text) return text.error();
    EditedScene scene{file, std::move(*text), {}};
    const auto full = scene.blocks();
    if (!full) return full.error();
    std::map<std::string, int> seen;
    for (const YamlValue& effect : effects_in(*full))
      for (const auto& [key, value] : effect.entries) {
        if (key != "use") continue;
        const int number = ++seen[value.text];
        scene.names_.push_back(number == 1 ? value.text : fmt::format("{}#{}", value.text, number));
      }
    return scene;
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// nullopt: with all of them.
  [[nodiscard]] Result<Plan> plan(std::optional<std::size_t> without, std::uint64_t seed) const {
    auto blocks_now = blocks();
    if (!blocks_now) return blocks_now.error();
    if (without)
      for (auto& [key, value] : *blocks_now)
        if (key == "effects")
          value.items.erase(value.items.begin() + static_cast<std::ptrdiff_t>(*without));
    YamlBlock block("");
    block.add_unknown({{"", *blocks_now}});
    const auto scene = Scene::parse(without ? block.on_many_lines() : text_, file_.string());
    if (!scene) return scene.error();
    return Plan::compile(*scene, seed);
  }

 private:
  using Blocks = std::vector<std::pair<std::string, YamlValue>>;
  EditedScene(std::filesystem::path file, std::string text, std::vector<std::string> names)
      : file_(std::move(file)), text_(std::move(text)), names_(std::move(names)) {}

  [[nodiscard]] Result<Blocks> blocks() const {
    YamlFile file(file_, YamlFile::Unknown::kRetained);
    const Status read = file.read(text_, [](YamlSection&) {});
    if (!read) return read.error();
    return Blocks(file.unknown()[""].begin(), file.unknown()[""].end());
  }
  static std::vector<YamlValue> effects_in(const Blocks& blocks) {
    for (const auto& [key, value] : blocks)
      if (key == "effects") return value.items;
    return {};
  }

  std::filesystem::path file_;
  std::string text_;
  std::vector<std::string> names_;
};

struct RenderedFrame {
  cv::Mat grey;
  double milliseconds = 0;
};

RenderedFrame render_timed(const Plan& plan, int frame) {
  const auto begin = std::chrono::steady_clock::now();
  RenderedFrame rendered{plan.send(frame).grey, 0};
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  rendered.milliseconds = taken.count();
  return rendered;
}

double grey_square_of(const cv::Mat& a, const cv::Mat& b) {
  const double norm = cv::norm(a, b, cv::NORM_L2);
  return norm * norm / static_cast<double>(a.total());
}

/// A frame of the full scene, and its comparison data.
struct FullFrame {
  int number = 0;
  cv::Mat grey, truth_mm;
  cv::Mat depth_mm;  // as the finger measures it; may be empty
};

class SimulatingRun {
 public:
  SimulatingRun(const EditedScene& scene, const Plan& full, std::optional<Pipeline> pipeline,
                int max_frames, std::uint64_t seed)
      : scene_(scene),
        full_(full),
        pipeline_(std::move(pipeline)),
        max_frames_(max_frames),
        seed_(seed) {}

  /// The full scene; called first.
  [[nodiscard]] Result<SimulatingRow> measure_full() {
    const int count = std::min(max_frames_, full_.frame_count());
    SimulatingRow row;
    std::vector<float> errors;
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      FullFrame frame;
      frame.number = i * full_.frame_count() / count;
      const RenderedFrame rendered = render_timed(full_, frame.number);
      frame.grey = rendered.grey;
      times.push_back(rendered.milliseconds);
      frame.truth_mm = full_.truth(frame.number).depth_mm;
      const auto depth = measured(frame.grey);
      if (!depth) return depth.error();
      frame.depth_mm = *depth;
      add_errors(frame.depth_mm, frame.truth_mm, errors);
      frames_.push_back(std::move(frame));
    }
    row.frames = count;
    row.depth = spread_of_errors(errors);
    row.render_ms = upper_median(times);
    return row;
  }

  [[nodiscard]] Result<SimulatingRow> measure_without(std::size_t effect) {
    SimulatingRow row;
    row.effect = scene_.names()[effect];
    const auto plan = scene_.plan(effect, seed_);
    if (!plan) {
      row.needed = plan.error().what;
      return row;
    }
    if (const Status grey = plan->check_grey_levels(row.effect); !grey) {
      row.needed = grey.error().what;
      return row;
    }
    std::vector<float> errors, changes;
    std::vector<double> times, ratios;
    double square = 0;
    for (const FullFrame& frame : frames_) {
      // In turn, so that both see the same load.
      const double full_ms = render_timed(full_, frame.number).milliseconds;
      const RenderedFrame rendered = render_timed(*plan, frame.number);
      if (rendered.grey.size() != frame.grey.size()) continue;
      ++row.frames;
      times.push_back(rendered.milliseconds);
      ratios.push_back(rendered.milliseconds / full_ms);
      square += grey_square_of(rendered.grey, frame.grey);
      const auto depth = measured(rendered.grey);
      if (!depth) return depth.error();
      add_errors(*depth, plan->truth(frame.number).depth_mm, errors);
      add_changes(*depth, frame, changes);
    }
    if (row.frames > 0) row.grey_rms = std::sqrt(square / row.frames);
    if (const auto change = spread_of_errors(changes)) row.depth_change_mm = change->median_mm;
    row.depth = spread_of_errors(errors);
    row.render_ms = upper_median(times);
    row.time_ratio = upper_median(ratios);
    return row;
  }

  [[nodiscard]] std::uint64_t checksum() const {
    std::vector<StudyFrame> frames;
    for (const FullFrame& full : frames_) {
      StudyFrame frame;
      auto image = std::make_shared<Frame>();
      image->grey = full.grey;
      frame.image = std::move(image);
      frame.depth_mm = full.truth_mm;
      frames.push_back(std::move(frame));
    }
    return checksum_of(frames);
  }

 private:
  /// Empty: there is no finger, or the image shows no depth.
  [[nodiscard]] Result<cv::Mat> measured(const cv::Mat& grey) {
    if (!pipeline_) return cv::Mat();
    auto frame = std::make_shared<Frame>();
    frame->grey = grey;
    pipeline_->forget();
    const auto result = (*pipeline_)(frame);
    if (!result) return result.error();
    return result->depth ? result->depth->depth_mm.clone() : cv::Mat();
  }

  static void add_errors(const cv::Mat& depth, const cv::Mat& truth, std::vector<float>& errors) {
    if (depth.empty()) return;
    for (int v = 0; v < depth.rows; ++v)
      for (int u = 0; u < depth.cols; ++u) {
        const float truly = truth.at<float>(v, u), read = depth.at<float>(v, u);
        if (truly > kPressedMm && std::isfinite(read)) errors.push_back(std::abs(read - truly));
      }
  }

  static void add_changes(const cv::Mat& depth, const FullFrame& full,
                          std::vector<float>& changes) {
    if (depth.empty() || full.depth_mm.empty()) return;
    for (int v = 0; v < depth.rows; ++v)
      for (int u = 0; u < depth.cols; ++u) {
        if (!(full.truth_mm.at<float>(v, u) > kPressedMm)) continue;
        const float change = depth.at<float>(v, u) - full.depth_mm.at<float>(v, u);
        if (std::isfinite(change)) changes.push_back(std::abs(change));
      }
  }

  const EditedScene& scene_;
  const Plan& full_;
  std::optional<Pipeline> pipeline_;
  int max_frames_;
  std::uint64_t seed_;
  std::vector<FullFrame> frames_;
};

/// Why the finger cannot measure the scene's images.
Message mismatch_of(const FingerPtr& finger, const Finger& shown) {
  if (!finger) return en::say("no finger was specified to measure these images");
  const Finger& own = finger->finger;
  const bool same = own.camera.width_px == shown.camera.width_px &&
                    own.camera.height_px == shown.camera.height_px &&
                    own.camera.fx_px == shown.camera.fx_px && own.face.kind == shown.face.kind &&
                    own.face.width_mm == shown.face.width_mm &&
                    own.face.layer_mm == shown.face.layer_mm;
  if (!same) return en::say("the scene shows another finger than {}", own.name);
  if (!finger->mapping) return en::say("{} is not calibrated", own.name);
  return {};
}

std::string micrometres_or_dash(const std::optional<double>& mm) {
  return mm ? fmt::format("{:.1f}", 1000 * *mm) : "-";
}

}  // namespace

Result<SimulatingStudy> study_simulating(const std::filesystem::path& file, const FingerPtr& finger,
                                         int max_frames, std::uint64_t seed, const Job& job) {
  const auto scene = EditedScene::read(file);
  if (!scene) return scene.error();
  const auto full = scene->plan({}, seed);
  if (!full) return full.error();
  if (const Status grey = full->check_grey_levels(file.string()); !grey) return grey.error();
  SimulatingStudy study;
  study.scene = file.stem().string();
  study.no_depth_reason = mismatch_of(finger, full->finger());
  std::optional<Pipeline> pipeline;
  if (study.no_depth_reason.empty()) {
    auto library = ReferenceLibrary::load(*finger, job);
    if (!library) return library.error();
    pipeline = Pipeline::with_library(std::move(*library), *finger, PipelineSettings{});
  }
  SimulatingRun run(*scene, *full, std::move(pipeline), max_frames, seed);
  auto first = run.measure_full();
  if (!first) return first.error();
  study.rows.push_back(std::move(*first));
  study.world_checksum = run.checksum();
  const StudyClock clock;
  for (std::size_t i = 0; i < scene->names().size(); ++i) {
    if (job.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
    clock.report(job, static_cast<double>(i) / static_cast<double>(scene->names().size()),
                 en::say("leaving out {}", scene->names()[i]));
    auto row = run.measure_without(i);
    if (!row) return row.error();
    study.rows.push_back(std::move(*row));
  }
  return study;
}

std::string text_of(const SimulatingStudy& study) {
  std::string text = fmt::format("{:<20} {:>9} {:>8} {:>10} {:>12} {:>10} {:>8}\n", "without", "ms",
                                 "ratio", "grey rms", "answer (um)", "error (um)", "95 %");
  for (const SimulatingRow& row : study.rows) {
    const std::string name = row.effect.empty() ? "nothing" : row.effect;
    if (!row.needed.empty()) {
      text += fmt::format("{:<20} cannot be left out: {}\n", name, row.needed);
      continue;
    }
    text += fmt::format(
        "{:<20} {:>9.2f} {:>8.3f} {:>10} {:>12} {:>10} {:>8}\n", name, row.render_ms,
        row.time_ratio, row.grey_rms ? fmt::format("{:.2f}", *row.grey_rms) : "-",
        micrometres_or_dash(row.depth_change_mm),
        micrometres_or_dash(row.depth ? std::optional(row.depth->median_mm) : std::nullopt),
        micrometres_or_dash(row.depth ? std::optional(row.depth->p95_mm) : std::nullopt));
  }
  if (!study.no_depth_reason.empty())
    text += fmt::format("No depth is measured: {}.\n", study.no_depth_reason);
  return text;
}

std::string svg_of(const SimulatingStudy& study) {
  StudyPlot plot;
  plot.title = "What each effect of a scene costs and changes";
  plot.subtitle = study.scene + " (simulated), one effect left out at a time";
  plot.x_label = "time that leaving it out saves of a frame on this computer, ms";
  plot.y_label = study.no_depth_reason.empty() ? "change of the measured depth, micrometres"
                                               : "change of the picture, grey levels (rms)";
  plot.has_staircase = false;
  const double full_ms = study.rows.front().render_ms;
  for (const SimulatingRow& row : study.rows) {
    const auto change = study.no_depth_reason.empty() ? row.depth_change_mm : row.grey_rms;
    if (!row.needed.empty() || !change) continue;
    PlotDot dot;
    dot.x = std::max(0.0, full_ms * (1 - row.time_ratio));
    dot.y = study.no_depth_reason.empty() ? 1000 * *change : *change;
    dot.is_on_front = true;
    dot.words = fmt::format("without {}: {:.2f} ms less, grey levels change by {:.1f}", row.effect,
                            dot.x, row.grey_rms.value_or(0));
    if (row.depth_change_mm)
      dot.words += fmt::format(", depth by {:.1f} \u00b5m", 1000 * *row.depth_change_mm);
    plot.dots.push_back(std::move(dot));
  }
  for (std::size_t i = 0; i < plot.dots.size(); ++i) plot.named.push_back(i);
  std::stable_sort(plot.named.begin(), plot.named.end(),
                   [&](std::size_t a, std::size_t b) { return plot.dots[a].y > plot.dots[b].y; });
  return svg_of(plot);
}

std::string csv_of(const SimulatingStudy& study) {
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
  };
  std::string csv =
      "without,can_be_left_out,frames,render_ms,time_ratio,grey_rms,answer_mm,depth_median_mm,"
      "depth_p95_mm\n";
  for (const SimulatingRow& row : study.rows)
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", row.effect, row.needed.empty() ? 1 : 0,
                       row.frames, row.render_ms, row.time_ratio, number(row.grey_rms),
                       number(row.depth_change_mm),
                       number(row.depth ? std::optional(row.depth->median_mm) : std::nullopt),
                       number(row.depth ? std::optional(row.depth->p95_mm) : std::nullopt));
  return csv;
}

nlohmann::json json_of(const SimulatingStudy& study) {
  nlohmann::json json{{"scene", study.scene},
                      {"truth", "simulated"},
                      {"world", fmt::format("{:016x}", study.world_checksum)}};
  if (!study.no_depth_reason.empty()) json["no_answer"] = study.no_depth_reason.english();
  nlohmann::json& rows = json["rows"] = nlohmann::json::array();
  for (const SimulatingRow& row : study.rows) {
    nlohmann::json entry{{"without", row.effect}};
    if (!row.needed.empty()) {
      entry["needed"] = row.needed.english();
      rows.push_back(std::move(entry));
      continue;
    }
    nlohmann::json errors{{"frames", row.frames}};
    if (row.grey_rms) errors["grey_rms"] = *row.grey_rms;
    if (row.depth_change_mm) errors["answer_mm"] = *row.depth_change_mm;
    if (row.depth)
      errors["depth"] = {{"median_mm", row.depth->median_mm}, {"p95_mm", row.depth->p95_mm}};
    entry["errors"] = std::move(errors);
    entry["times"] = {{"median_ms", row.render_ms}, {"ratio", row.time_ratio}};
    rows.push_back(std::move(entry));
  }
  return json;
}

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
                                   const StudyWorldOptions& options, const Job& job) {
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
  StudyWorld world{en::say("the demonstration's finger, simulated, pressed at random positions"),
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
