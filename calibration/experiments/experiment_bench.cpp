#include "calibration/experiments/experiment_bench.h"

#include "calibration/experiments/force_experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/force/train_force.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/atomic_file.h"
#include "core/base/cache.h"
#include "core/base/program.h"
#include "core/base/result.h"
#include "core/base/yaml.h"
#include "core/numerics/checksum.h"
#include "core/numerics/parallel.h"
#include "core/numerics/philox.h"
#include "core/simulation/scene.h"
#include "core/sources/source.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
Result<Plan> plan_of_scene(const std::string& name, std::uint64_t seed,
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
std::vector<FramePtr> frames_of_plan(const Plan& plan, const cv::Range& range, int every,
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

std::vector<Shot> shots_of_plan(const Plan& plan, const cv::Range& range, TruthDetail detail,
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

Error stopped_in_experiment() { return {en::say("stopped before the experiments ended"), "", ""}; }

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
      ready_ = frames_of_plan(plan_, {position_, std::min(frame_count(), position_ + kBatchFrames)},
                              every_, threads_);
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
  std::vector<std::string> made_by{options_.name, std::to_string(options_.seed),
                                   std::to_string(options_.recording_every)};
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

Result<int> ExperimentBench::measure(const std::string& scene, const Measuring& measuring,
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
      shots = shots_of_plan(*scene_plan, {number, std::min(count, number + kBatchFrames)},
                            measuring.truth, options_.threads);
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

namespace {

constexpr double kFullWidth_px = 960, kFullHeight_px = 540;

YamlValue number_value(double value) {
  YamlValue made;
  made.kind = YamlValue::Kind::kScalar;
  made.text = yaml_number(value);
  return made;
}

YamlValue* entry_of(YamlValue& map, std::string_view key) {
  for (auto& [name, value] : map.entries)
    if (name == key) return &value;
  return nullptr;
}

/// Sets the value where the map has the key.
void put(YamlValue& map, std::string_view key, double value) {
  if (YamlValue* entry = entry_of(map, key)) *entry = number_value(value);
}

void put_integer(YamlValue& map, std::string_view key, int value) {
  if (YamlValue* entry = entry_of(map, key)) entry->text = std::to_string(value);
}

void put_camera(YamlValue& camera, const FingerVariant& f) {
  if (YamlValue* size = entry_of(camera, "size"); size != nullptr && size->items.size() == 2) {
    size->items[0].text = std::to_string(std::lround(kFullWidth_px * f.scale));
    size->items[1].text = std::to_string(std::lround(kFullHeight_px * f.scale));
  }
  put(camera, "fx", f.focal_px * f.scale);
  put(camera, "fy", f.focal_px * f.scale);
  // The middle of the first pixel lies at 0.
  put(camera, "cx", (f.cx_px + 0.5) * f.scale - 0.5);
  put(camera, "cy", (f.cy_px + 0.5) * f.scale - 0.5);
}

void put_finger(YamlValue& finger, const FingerVariant& f) {
  if (YamlValue* camera = entry_of(finger, "camera")) put_camera(*camera, f);
  if (YamlValue* face = entry_of(finger, "face")) {
    put(*face, "width_mm", f.width_mm);
    put(*face, "layer_mm", f.layer_mm);
  }
  if (YamlValue* markers = entry_of(finger, "markers")) put_integer(*markers, "per_row", f.per_row);
}

void put_pose(YamlValue& untouched, const FingerVariant& f) {
  put(untouched, "x_mm", f.x_mm);
  put(untouched, "z_mm", f.z_mm);
  put(untouched, "incline_deg", f.incline_deg);
  put(untouched, "length_mm", f.length_mm);
}

void put_lamps(YamlValue& leds, const FingerVariant& f) {
  YamlValue* lamps = entry_of(leds, "lamps");
  if (lamps == nullptr) return;
  for (YamlValue& lamp : lamps->items)
    if (YamlValue* power = entry_of(lamp, "power"))
      *power = number_value(f.light * std::strtod(power->text.c_str(), nullptr));
}

void put_effect(YamlValue& effect, const FingerVariant& f) {
  const YamlValue* use = entry_of(effect, "use");
  if (use == nullptr) return;
  if (use->text == "markers") {
    put(effect, "radius_mm", f.dot_radius_mm);
    put(effect, "setback_mm", f.setback_mm);
    put(effect, "first", f.first);
    put(effect, "last", f.last);
    put(effect, "albedo", f.dot_albedo);
  } else if (use->text == "layer") {
    put(effect, "scatter_per_mm", f.scatter_per_mm);
  } else if (use->text == "sides") {
    put(effect, "albedo", f.side_albedo);
  } else if (use->text == "leds") {
    put_lamps(effect, f);
  } else if (use->text == "body") {
    put(effect, "shore_a", f.shore_a);
    put(effect, "wall_mm", f.wall_mm);
    put(effect, "base_depth_mm", f.base_depth_mm);
    put(effect, "tip_depth_mm", f.tip_depth_mm);
    put(effect, "coupling", f.coupling);
  } else if (use->text == "push") {
    put(effect, "layer_shore_a", f.layer_shore_a);
  } else if (use->text == "ambient" && f.room_level) {
    put(effect, "level", *f.room_level);
  }
}

}  // namespace

FingerVariant FingerVariant::draw(std::uint64_t seed, int number) {
  std::uint32_t drawn = 0;
  const auto between = [&](double low, double high) {
    return low + (high - low) * philox_uniform(seed, "drawn finger",
                                               static_cast<std::uint32_t>(number), drawn++);
  };
  FingerVariant finger;
  finger.width_mm = between(20, 27);
  finger.layer_mm = between(1.3, 1.7);
  finger.x_mm = between(-24.5, -21);
  finger.z_mm = between(28, 32);
  finger.incline_deg = between(31, 37);
  finger.length_mm = between(112, 124);
  finger.focal_px = between(480, 530);
  finger.cx_px = between(472, 488);
  finger.cy_px = between(260, 280);
  finger.per_row = static_cast<int>(between(5, 10));
  finger.dot_radius_mm = between(1.1, 1.6);
  finger.setback_mm = between(3.5, 5);
  finger.first = between(0.08, 0.14);
  finger.last = between(0.84, 0.92);
  finger.dot_albedo = between(0.75, 0.95);
  finger.scatter_per_mm = between(0.5, 0.7);
  finger.side_albedo = between(0.08, 0.15);
  finger.light = between(0.8, 1.1);
  finger.shore_a = between(32, 50);
  finger.wall_mm = between(3.5, 4.5);
  finger.base_depth_mm = between(31, 37);
  finger.tip_depth_mm = between(11, 14);
  finger.coupling = between(0.3, 0.7);
  finger.layer_shore_a = between(4, 8);
  return finger;
}

Result<std::string> scene_text_on_finger(std::string_view yaml, const std::filesystem::path& origin,
                                         const FingerVariant& finger) {
  YamlFile file(origin, YamlFile::Unknown::kRetained);
  const Status read = file.read(std::string(yaml), [](YamlSection&) {});
  if (!read) return read.error();
  for (auto& [key, value] : file.unknown()[""]) {
    if (key == "finger") put_finger(value, finger);
    if (key == "untouched") put_pose(value, finger);
    if (key == "effects")
      for (YamlValue& effect : value.items) put_effect(effect, finger);
  }
  YamlBlock scene("");
  scene.add_unknown(file.unknown());
  return scene.on_many_lines();
}

Result<Scene> scene_on_finger(std::string_view yaml, const std::filesystem::path& origin,
                              const FingerVariant& finger) {
  const auto text = scene_text_on_finger(yaml, origin, finger);
  if (!text) return text.error();
  return Scene::parse(*text, origin.string());
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxCached = 8;
constexpr const char* kListFile = "kept.json";
constexpr const char* kFingerFolder = "finger";
constexpr const char* kUnfinished = ".unfinished-";

/// Of a file's bytes; nullopt: it cannot be read.
std::optional<std::string> file_checksum(const fs::path& file) {
  const auto bytes = read_file(file);
  if (!bytes) return std::nullopt;
  Checksum sum;
  sum.add(bytes->data(), bytes->size());
  return sum.text();
}

/// Checksum of the program's code.
const std::string& program_checksum() {
  static const std::string checksum =
      checksum_of_code(reinterpret_cast<const void*>(&program_version)) +
      checksum_of_code(reinterpret_cast<const void*>(&cached_finger_name));
  return checksum;
}

/// Relative, in order of their names.
std::vector<fs::path> files_below(const fs::path& folder, std::error_code& failed) {
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed))
    if (entry->is_regular_file(failed)) files.push_back(entry->path().lexically_relative(folder));
  std::sort(files.begin(), files.end());
  return files;
}

/// Returns the checksum of each copied file. nullopt: a file cannot be read or written.
std::optional<nlohmann::ordered_json> copy_files(const fs::path& from, const fs::path& to) {
  std::error_code failed;
  auto sums = nlohmann::ordered_json::object();
  for (const fs::path& file : files_below(from, failed)) {
    fs::create_directories((to / file).parent_path(), failed);
    if (failed || !fs::copy_file(from / file, to / file, failed)) return std::nullopt;
    const auto sum = file_checksum(to / file);
    if (!sum) return std::nullopt;
    sums[file.generic_string()] = *sum;
  }
  if (failed || sums.empty()) return std::nullopt;
  return sums;
}

void remove_quietly(const fs::path& folder) {
  std::error_code failed;
  fs::remove_all(folder, failed);
}

Error caching_error(const fs::path& where, int code) {
  return system_error(en::say("could not save the simulated finger for the next time"), where,
                      code);
}

/// A new folder next to the cached ones.
Result<fs::path> unfinished_folder(const fs::path& cache) {
  if (const Status made = make_folder(cache); !made) return made.error();
  std::string path = (cache / (std::string(kUnfinished) + "XXXXXX")).string();
  if (mkdtemp(path.data()) == nullptr) return caching_error(cache, errno);
  return fs::path(path);
}

/// Something exists at the target of a rename: another program's folder, or the rest of one.
bool is_occupied(const std::error_code& failed) {
  return failed == std::errc::directory_not_empty || failed == std::errc::file_exists ||
         failed == std::errc::not_a_directory;
}

/// Renames `made` into the cache, which other programs may change at the same time.
std::error_code rename_into_cache(const fs::path& made, const fs::path& cache,
                                  const std::string& name) {
  constexpr int kMostTries = 100;  // each that fails is another program's success
  std::error_code failed;
  for (int i = 0; i < kMostTries; ++i) {
    fs::rename(made, cache / name, failed);
    if (!is_occupied(failed)) break;
    // Another program was first, or the existing folder is damaged; this one is complete in
    // both cases. The old one is renamed first, so that no program sees half of it.
    const auto aside = unfinished_folder(cache);
    if (!aside) break;
    std::error_code no_matter;
    fs::rename(cache / name, *aside / "old", no_matter);
    remove_quietly(*aside);
  }
  return failed;
}

}  // namespace

std::string cached_finger_name(const std::vector<std::string_view>& made_by) {
  Checksum sum;
  sum.add(program_checksum().data(), program_checksum().size());
  for (const std::string_view words : made_by) {
    const std::uint64_t length = words.size();  // so that shifted borders change the sum
    sum.add(&length, sizeof length);
    sum.add(words.data(), words.size());
  }
  return fmt::format("{}-{}", program_version(), sum.text());
}

std::optional<std::string> load_cached_finger(const fs::path& cache, const std::string& name,
                                              const fs::path& to) {
  const auto text = read_file(cache / name / kListFile);
  if (!text) return std::nullopt;
  const auto list = nlohmann::ordered_json::parse(*text, nullptr, false);
  if (!list.is_object() || !list.contains("files") || !list.contains("note") ||
      !list["note"].is_string())
    return std::nullopt;
  // The copy is verified, not the cache, which may change meanwhile.
  const auto copied = copy_files(cache / name / kFingerFolder, to);
  if (copied && *copied == list["files"]) return list["note"].get<std::string>();
  remove_quietly(to);
  return std::nullopt;
}

Status cache_finger(const fs::path& cache, const std::string& name, const fs::path& finger_folder,
                    const std::string& note) {
  const auto made = unfinished_folder(cache);
  if (!made) return made.error();
  const auto files = copy_files(finger_folder, *made / kFingerFolder);
  const int code = errno;
  if (!files) {
    remove_quietly(*made);
    return caching_error(cache, code);
  }
  const nlohmann::ordered_json list{{"note", note}, {"files", *files}};
  const Status listed = write_file_atomically(*made / kListFile, list.dump(1) + "\n");
  if (!listed) {
    remove_quietly(*made);
    return listed;
  }
  if (const std::error_code failed = rename_into_cache(*made, cache, name)) {
    remove_quietly(*made);
    return caching_error(cache, failed.value());
  }
  remove_oldest(cache, kMaxCached);
  return {};
}

}  // namespace alltact
