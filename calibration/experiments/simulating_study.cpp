#include "calibration/experiments/simulating_study.h"

#include "calibration/study/real_presses.h"
#include "calibration/study/study_clock.h"
#include "calibration/study/study_plot.h"
#include "calibration/study/study_world.h"
#include "calibration/study/truly_pressed.h"
#include "core/io/atomic_file.h"
#include "core/sensing/pipeline.h"
#include "core/simulation/plan.h"
#include "core/yaml/yaml_file.h"
#include "core/yaml/yaml_writer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

/// The text of a scene without one of its effects, and what the file calls each.
class EditedScene {
 public:
  static Result<EditedScene> read(const std::filesystem::path& file) {
    auto text = read_file(file);
    if (!text) return text.error();
    EditedScene scene{file, std::move(*text), {}};
    const auto whole = scene.blocks();
    if (!whole) return whole.error();
    std::map<std::string, int> seen;
    for (const YamlValue& effect : effects_in(*whole))
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
    YamlFile file(file_, YamlFile::Unknown::kKept);
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

double middle_of(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(),
                   values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// A frame of the whole scene, with what is compared with it.
struct WholeFrame {
  int number = 0;
  cv::Mat grey, truth_mm;
  cv::Mat depth_mm;  // as the finger measures it; may be empty
};

class SimulatingRun {
 public:
  SimulatingRun(const EditedScene& scene,
                const Plan& whole,
                std::optional<Pipeline> pipeline,
                const SimulatingOptions& options)
      : scene_(scene), whole_(whole), pipeline_(std::move(pipeline)), options_(options) {}

  /// The whole scene; first of all.
  [[nodiscard]] Result<SimulatingRow> look_at_whole() {
    const int count = std::min(options_.frames, whole_.frame_count());
    SimulatingRow row;
    std::vector<float> errors;
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      WholeFrame frame;
      frame.number = i * whole_.frame_count() / count;
      const RenderedFrame rendered = render_timed(whole_, frame.number);
      frame.grey = rendered.grey;
      times.push_back(rendered.milliseconds);
      frame.truth_mm = whole_.truth(frame.number).depth_mm;
      const auto depth = measured(frame.grey);
      if (!depth) return depth.error();
      frame.depth_mm = *depth;
      add_errors(frame.depth_mm, frame.truth_mm, errors);
      frames_.push_back(std::move(frame));
    }
    row.frames = count;
    row.depth = spread_of_errors(errors);
    row.render_ms = middle_of(times);
    return row;
  }

  [[nodiscard]] Result<SimulatingRow> look_without(std::size_t effect) {
    SimulatingRow row;
    row.effect = scene_.names()[effect];
    const auto plan = scene_.plan(effect, options_.seed);
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
    for (const WholeFrame& frame : frames_) {
      // Turn by turn, so that both meet the same computer.
      const double whole_ms = render_timed(whole_, frame.number).milliseconds;
      const RenderedFrame rendered = render_timed(*plan, frame.number);
      if (rendered.grey.size() != frame.grey.size()) continue;
      ++row.frames;
      times.push_back(rendered.milliseconds);
      ratios.push_back(rendered.milliseconds / whole_ms);
      square += grey_square_of(rendered.grey, frame.grey);
      const auto depth = measured(rendered.grey);
      if (!depth) return depth.error();
      add_errors(*depth, plan->truth(frame.number).depth_mm, errors);
      add_changes(*depth, frame, changes);
    }
    if (row.frames > 0) row.grey_rms = std::sqrt(square / row.frames);
    if (const auto change = spread_of_errors(changes)) row.answer_mm = change->median_mm;
    row.depth = spread_of_errors(errors);
    row.render_ms = middle_of(times);
    row.time_ratio = middle_of(ratios);
    return row;
  }

  [[nodiscard]] std::uint64_t checksum() const {
    std::vector<StudyFrame> frames;
    for (const WholeFrame& whole : frames_) {
      StudyFrame frame;
      auto picture = std::make_shared<Frame>();
      picture->grey = whole.grey;
      frame.picture = std::move(picture);
      frame.depth_mm = whole.truth_mm;
      frames.push_back(std::move(frame));
    }
    return checksum_of(frames);
  }

 private:
  /// Empty: nobody measures, or the picture shows no depth.
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

  static void add_changes(const cv::Mat& depth,
                          const WholeFrame& whole,
                          std::vector<float>& changes) {
    if (depth.empty() || whole.depth_mm.empty()) return;
    for (int v = 0; v < depth.rows; ++v)
      for (int u = 0; u < depth.cols; ++u) {
        if (!(whole.truth_mm.at<float>(v, u) > kPressedMm)) continue;
        const float change = depth.at<float>(v, u) - whole.depth_mm.at<float>(v, u);
        if (std::isfinite(change)) changes.push_back(std::abs(change));
      }
  }

  const EditedScene& scene_;
  const Plan& whole_;
  std::optional<Pipeline> pipeline_;
  SimulatingOptions options_;
  std::vector<WholeFrame> frames_;
};

/// Why the finger cannot measure what the scene shows.
Message not_of(const FingerPtr& finger, const Finger& shown) {
  if (!finger) return en::say("no finger was given that measures these pictures");
  const Finger& ours = finger->finger;
  const bool same = ours.camera.width_px == shown.camera.width_px &&
                    ours.camera.height_px == shown.camera.height_px &&
                    ours.camera.fx_px == shown.camera.fx_px && ours.face.kind == shown.face.kind &&
                    ours.face.width_mm == shown.face.width_mm &&
                    ours.face.layer_mm == shown.face.layer_mm;
  if (!same) return en::say("the scene shows another finger than {}", ours.name);
  if (!finger->mapping) return en::say("{} is not calibrated", ours.name);
  return {};
}

std::string micrometres_or_dash(const std::optional<double>& mm) {
  return mm ? fmt::format("{:.1f}", 1000 * *mm) : "-";
}

}  // namespace

Result<SimulatingStudy> study_simulating(const std::filesystem::path& file,
                                         const FingerPtr& finger,
                                         const SimulatingOptions& options,
                                         const Job& job) {
  const auto scene = EditedScene::read(file);
  if (!scene) return scene.error();
  const auto whole = scene->plan({}, options.seed);
  if (!whole) return whole.error();
  if (const Status grey = whole->check_grey_levels(file.string()); !grey) return grey.error();
  SimulatingStudy study;
  study.scene = file.stem().string();
  study.no_answer = not_of(finger, whole->finger());
  std::optional<Pipeline> pipeline;
  if (study.no_answer.empty()) {
    auto library = ReferenceLibrary::load(*finger, job);
    if (!library) return library.error();
    pipeline = Pipeline::over(std::move(*library), *finger, PipelineSettings{});
  }
  SimulatingRun run(*scene, *whole, std::move(pipeline), options);
  auto first = run.look_at_whole();
  if (!first) return first.error();
  study.rows.push_back(std::move(*first));
  study.world_checksum = run.checksum();
  const StudyClock clock;
  for (std::size_t i = 0; i < scene->names().size(); ++i) {
    if (job.stop_requested()) return Error{en::say("stopped before the study was over"), "", ""};
    clock.report(job,
                 static_cast<double>(i) / static_cast<double>(scene->names().size()),
                 en::say("leaving out {}", scene->names()[i]));
    auto row = run.look_without(i);
    if (!row) return row.error();
    study.rows.push_back(std::move(*row));
  }
  return study;
}

std::string text_of(const SimulatingStudy& study) {
  std::string text = fmt::format("{:<20} {:>9} {:>8} {:>10} {:>12} {:>10} {:>8}\n",
                                 "without",
                                 "ms",
                                 "ratio",
                                 "grey rms",
                                 "answer (um)",
                                 "error (um)",
                                 "95 %");
  for (const SimulatingRow& row : study.rows) {
    const std::string name = row.effect.empty() ? "nothing" : row.effect;
    if (!row.needed.empty()) {
      text += fmt::format("{:<20} cannot be left out: {}\n", name, row.needed);
      continue;
    }
    text += fmt::format(
        "{:<20} {:>9.2f} {:>8.3f} {:>10} {:>12} {:>10} {:>8}\n",
        name,
        row.render_ms,
        row.time_ratio,
        row.grey_rms ? fmt::format("{:.2f}", *row.grey_rms) : "-",
        micrometres_or_dash(row.answer_mm),
        micrometres_or_dash(row.depth ? std::optional(row.depth->median_mm) : std::nullopt),
        micrometres_or_dash(row.depth ? std::optional(row.depth->p95_mm) : std::nullopt));
  }
  if (!study.no_answer.empty()) text += fmt::format("No depth is measured: {}.\n", study.no_answer);
  return text;
}

std::string svg_of(const SimulatingStudy& study) {
  StudyPlot plot;
  plot.title = "What each effect of a scene costs and changes";
  plot.subtitle = study.scene + " (simulated), one effect left out at a time";
  plot.x_label = "time that leaving it out saves of a frame on this computer, ms";
  plot.y_label = study.no_answer.empty() ? "change of the measured depth, micrometres"
                                         : "change of the picture, grey levels (rms)";
  plot.has_staircase = false;
  const double whole_ms = study.rows.front().render_ms;
  for (const SimulatingRow& row : study.rows) {
    const auto change = study.no_answer.empty() ? row.answer_mm : row.grey_rms;
    if (!row.needed.empty() || !change) continue;
    PlotDot dot;
    dot.x = std::max(0.0, whole_ms * (1 - row.time_ratio));
    dot.y = study.no_answer.empty() ? 1000 * *change : *change;
    dot.is_on_front = true;
    dot.words = fmt::format("without {}: {:.2f} ms less, grey levels change by {:.1f}",
                            row.effect,
                            dot.x,
                            row.grey_rms.value_or(0));
    if (row.answer_mm) dot.words += fmt::format(", depth by {:.1f} \u00b5m", 1000 * *row.answer_mm);
    plot.dots.push_back(std::move(dot));
  }
  for (std::size_t i = 0; i < plot.dots.size(); ++i) plot.named.push_back(i);
  std::stable_sort(plot.named.begin(), plot.named.end(), [&](std::size_t a, std::size_t b) {
    return plot.dots[a].y > plot.dots[b].y;
  });
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
    csv += fmt::format("{},{},{},{},{},{},{},{},{}\n",
                       row.effect,
                       row.needed.empty() ? 1 : 0,
                       row.frames,
                       row.render_ms,
                       row.time_ratio,
                       number(row.grey_rms),
                       number(row.answer_mm),
                       number(row.depth ? std::optional(row.depth->median_mm) : std::nullopt),
                       number(row.depth ? std::optional(row.depth->p95_mm) : std::nullopt));
  return csv;
}

nlohmann::json json_of(const SimulatingStudy& study) {
  nlohmann::json json{{"scene", study.scene},
                      {"truth", "simulated"},
                      {"world", fmt::format("{:016x}", study.world_checksum)}};
  if (!study.no_answer.empty()) json["no_answer"] = study.no_answer.english();
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
    if (row.answer_mm) errors["answer_mm"] = *row.answer_mm;
    if (row.depth)
      errors["depth"] = {{"median_mm", row.depth->median_mm}, {"p95_mm", row.depth->p95_mm}};
    entry["errors"] = std::move(errors);
    entry["times"] = {{"median_ms", row.render_ms}, {"ratio", row.time_ratio}};
    rows.push_back(std::move(entry));
  }
  return json;
}

}  // namespace alltact
