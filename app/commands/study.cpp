// Output files of every study.
#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/figures/figures.h"
#include "calibration/experiments/experiment_bench.h"
#include "calibration/experiments/simulating_study.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/study/accuracy_study.h"
#include "calibration/study/calibrating_study.h"
#include "calibration/study/real_presses.h"
#include "calibration/study/recommended_settings.h"
#include "calibration/study/scaling_study.h"
#include "calibration/study/study_file.h"
#include "calibration/study/study_machine.h"
#include "calibration/study/study_plot.h"
#include "core/base/atomic_file.h"
#include "core/base/program.h"
#include "core/base/result.h"
#include "core/base/utc_time.h"

#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

struct StudyCommandOptions {
  /// None: the demonstration's, simulated; with `simulating` the scene (none: demo_presses).
  std::vector<Path> fingers;
  std::optional<Path> folder;  ///< stores the study; empty: nothing is stored
  bool quick = false;          ///< one setting at a time, a few frames
  bool calibrating = false;    ///< instead: cost and benefit of presses, frames and methods
  bool simulating = false;     ///< instead: cost and influence of each effect of a scene
  bool scaling = false;        ///< instead: time and memory over the size of the measured data
  std::optional<double> max_time_ms, max_error_mm, position_mm;
  bool save = false;  ///< stores the presets with the finger
  std::string use;    ///< settings that the finger uses from now on (study.cpp); empty: as before
  std::uint64_t seed = 1;
  int threads = 1;
};

/// Program, date, machine with its power, seed.
[[nodiscard]] Console::Json study_provenance(const StudyCommandOptions& options);

struct StudyFiles {
  nlohmann::json json;   ///< of the study itself
  std::string csv, svg;  ///< svg: empty where there is no figure
};

/// Writes study.json (with `provenance`), study.csv and study.svg into the folder, and prints it.
/// Also study.png and study.pdf where this computer has the library that draws. Error: a file
/// cannot be written.
[[nodiscard]] Status write_study(const StudyFiles& files, const Console::Json& provenance,
                                 const Path& folder, Console& console);

constexpr int kQuickSceneFrames = 4, kSceneFrames = 12;
constexpr const char* kDefaultScene = "demo_presses";

/// The given scene: a file, or a name among the program's own.
Result<Path> scene_file(const std::vector<Path>& named) {
  if (named.empty()) return find_resource(fmt::format("scenes/{}.yaml", kDefaultScene));
  std::error_code failed;
  if (named.front().extension() == ".yaml" || std::filesystem::exists(named.front(), failed))
    return named.front();
  return find_resource("scenes/" + named.front().string() + ".yaml");
}

/// The figure, also as PNG and PDF where this computer has the library that draws.
Status add_figures(const std::string& svg, const Console::Json& provenance,
                   std::vector<ReportFile>& all, Console& console) {
  all.push_back({"study.svg", svg});
  const auto drawing = load_figures();
  if (!drawing) {
    console.warn(drawing.error().sentence());
    return {};
  }
  auto drawn = (*drawing)->figure_files(svg, "study", provenance.value("date", std::string()));
  if (!drawn) return drawn.error();
  all.insert(all.end(), drawn->begin(), drawn->end());
  return {};
}

/// Prints a study and stores it; `name` is of its folder below the given one.
template <class Study>
Status publish_study(const Study& study, const std::string& svg, const std::string& name,
                     const StudyCommandOptions& options, Console& console) {
  console.say(text_of(study));
  console.answer()["studies"].push_back(Console::Json::parse(json_of(study).dump()));
  if (!options.folder) return {};
  const Path folder = *options.folder / name;
  if (const Status made = make_folder(folder); !made) return made;
  return write_study({json_of(study), csv_of(study), svg}, study_provenance(options), folder,
                     console);
}

/// The demonstration's finger, which measures all that a study needs.
Result<FingerPtr> simulated_finger(const StudyCommandOptions& options, const Path& folder,
                                   Console& console) {
  BenchOptions bench_options;
  bench_options.folder = folder;
  bench_options.seed = options.seed;
  bench_options.threads = options.threads;
  const auto bench = ExperimentBench::make(bench_options, console.job());
  if (!bench) return bench.error();
  return open_finger(bench->finger().folder);
}

Console::Json study_provenance(const StudyCommandOptions& options) {
  Console::Json json{{"program", program_version()}, {"date", utc_now()}};
  json["machine"] = Console::Json::parse(json_of(this_machine()).dump());
  json["threads"] = options.threads;
  json["seed"] = options.seed;
  return json;
}

Status write_study(const StudyFiles& files, const Console::Json& provenance, const Path& folder,
                   Console& console) {
  Console::Json json = provenance;
  json["study"] = Console::Json::parse(files.json.dump());
  std::vector<ReportFile> all{{"study.json", json.dump(2) + "\n"}, {"study.csv", files.csv}};
  if (!files.svg.empty())
    if (const Status drawn = add_figures(files.svg, provenance, all, console); !drawn) return drawn;
  std::string names;
  for (const ReportFile& file : all) {
    if (const Status written = write_file_atomically(folder / file.name, file.content); !written)
      return written;
    names += (names.empty() ? "" : ", ") + file.name;
  }
  console.say(fmt::format("Saved in {}: {}.", folder.string(), names));
  return {};
}

/// `alltact study --calibrating`, `--simulating` and `--scaling`.
Status run_calibrating_study(const StudyCommandOptions& options, Console& console) {
  if (options.fingers.empty())
    return Error{en::say("no finger was named whose calibration is to be studied"), "",
                 en::say("alltact study --calibrating FINGER")};
  console.answer() = study_provenance(options);
  console.answer()["studies"] = Console::Json::array();
  for (const Path& folder : options.fingers) {
    const auto finger = open_finger(folder, console);
    if (!finger) return finger.error();
    CalibratingOptions how;
    how.seed = options.seed;
    how.quick = options.quick;
    const auto study = study_calibrating(*finger, how, console.job());
    if (!study) return study.error();
    console.say(study->about.english());
    if (const Status published = publish_study(
            *study, svg_of(*study), folder.filename().string() + "_calibrating", options, console);
        !published)
      return published;
  }
  return {};
}

Status run_simulating_study(const StudyCommandOptions& options, Console& console) {
  if (options.fingers.size() > 1)
    return Error{en::say("one scene at a time is studied"), options.fingers[1].string(), ""};
  console.answer() = study_provenance(options);
  console.answer()["studies"] = Console::Json::array();
  const auto scene = scene_file(options.fingers);
  if (!scene) return scene.error();
  const auto passing = ScopedFolder::make(en::say("a folder for the study cannot be made"));
  if (!passing) return passing.error();
  const auto finger = simulated_finger(options, passing->path(), console);
  if (!finger) return finger.error();
  const int max_frames = options.quick ? kQuickSceneFrames : kSceneFrames;
  const auto study = study_simulating(*scene, *finger, max_frames, options.seed, console.job());
  if (!study) return study.error();
  console.say(fmt::format("{}, {} images (simulated)", study->scene, study->rows.front().frames));
  return publish_study(*study, svg_of(*study), study->scene + "_simulating", options, console);
}

Status run_scaling_study(const StudyCommandOptions& options, Console& console) {
  console.answer() = study_provenance(options);
  console.answer()["studies"] = Console::Json::array();
  ScalingOptions how;
  how.seed = options.seed;
  how.quick = options.quick;
  how.threads = options.threads;
  const auto study_one = [&](const FingerPtr& finger, const std::string& name) -> Status {
    const auto study = study_scaling(finger, how, console.job());
    if (!study) return study.error();
    return publish_study(*study, {}, name + "_scaling", options, console);
  };
  if (options.fingers.empty()) {
    const auto passing = ScopedFolder::make(en::say("a folder for the study cannot be made"));
    if (!passing) return passing.error();
    const auto finger = simulated_finger(options, passing->path(), console);
    return finger ? study_one(*finger, "simulated") : Status(finger.error());
  }
  for (const Path& folder : options.fingers) {
    const auto finger = open_finger(folder, console);
    if (!finger) return finger.error();
    if (Status published = study_one(*finger, folder.filename().string()); !published)
      return published;
  }
  return {};
}

constexpr const char* kWithin = "within-ms";
constexpr const char* kKeep = "keep-mm";
constexpr const char* kCalibrated = "calibrated";

Status use(const Path& finger, const PipelineSettings& settings, const std::string& name,
           Console& console) {
  const auto store = FingerStore::of(finger);
  if (const Status used = use_settings(*store, settings, name); !used) return used;
  const auto presets = presets_of_finger(finger);
  if (!presets) return presets.error();
  const std::string flags = flags_of(settings, presets->calibrated);
  console.say(fmt::format("{} now measures with '{}': {}. To revert: alltact study {} --use {}",
                          finger.string(), name, flags.empty() ? "as calibrated" : flags,
                          finger.string(), kCalibrated));
  console.answer()["used"] = {{"name", name}, {"flags", flags}};
  return {};
}

/// The row within a limit, with the request as text.
Result<std::pair<std::size_t, std::string>> row_within(const StudyCommandOptions& options,
                                                       const AccuracyStudy& study) {
  const bool is_time = options.use == kWithin;
  const auto row = is_time ? most_accurate_within(study, *options.max_time_ms, options.position_mm)
                           : fastest_within(study, *options.max_error_mm, options.position_mm);
  const std::string name = is_time ? fmt::format("within {} ms", *options.max_time_ms)
                                   : fmt::format("95 % within {} mm", *options.max_error_mm);
  if (!row)
    return Error{en::say("no setting is {}", name), "",
                 en::say("a wider limit; the table above tells what there is")};
  return std::pair{*row, name};
}

/// `--save` and `--use`.
void add_use_flags(CLI::App& command, StudyCommandOptions& options) {
  command.add_flag("--save", options.save,
                   "Saves the presets fast, balanced and finest with the finger, for --preset");
  command
      .add_option("--use", options.use,
                  "Settings with which the finger measures from now on, everywhere: a stored "
                  "preset or, with --save, one of this study; within-ms or keep-mm, the result of "
                  "those options; calibrated, to revert")
      ->type_name("NAME")
      ->check(CLI::IsMember({"fast", "balanced", "finest", kCalibrated, kWithin, kKeep}));
}

/// Refuses options that do not go together. Throws CLI::ValidationError.
void check_use_flags(const StudyCommandOptions& options) {
  if ((options.save || !options.use.empty()) && options.fingers.empty())
    throw CLI::ValidationError(options.save ? "--save" : "--use", "needs a FINGER");
  if ((options.save || !options.use.empty()) &&
      (options.calibrating || options.simulating || options.scaling))
    throw CLI::ValidationError(
        options.save ? "--save" : "--use",
        "does not apply to that study, which compares no settings for measuring frames");
  if (options.use == kWithin && !options.max_time_ms) throw CLI::RequiredError("--within-ms");
  if (options.use == kKeep && !options.max_error_mm) throw CLI::RequiredError("--keep-mm");
}

/// The requested preset is stored already, so that no study is needed.
bool uses_stored_preset(const StudyCommandOptions& options) {
  return !options.save && !options.use.empty() && options.use != kWithin && options.use != kKeep;
}

/// Makes a finger measure with one of its stored presets, or as it was calibrated. Errors: those of
/// preset_settings() and use_settings().
Status use_stored_preset(const Path& finger, const std::string& name, Console& console) {
  if (name == kCalibrated) {
    const auto store = FingerStore::of(finger);
    if (const auto there = store->snapshot(); !there) return there.error();
    if (const Status back = use_calibrated_settings(*store); !back) return back;
    console.say(fmt::format("{} now measures as calibrated.", finger.string()));
    console.answer()["used"] = {{"name", name}, {"flags", ""}};
    return {};
  }
  const auto settings = preset_settings(finger, name);
  if (!settings) return settings.error();
  return use(finger, *settings, name, console);
}

/// Stores and uses the result of a study of the finger, as far as the options request it. Errors:
/// the preset has no advantage on this finger; nothing is within the limit; those of
/// save_presets().
Status save_and_use(const StudyCommandOptions& options, const AccuracyStudy& study,
                    const Path& finger, const std::string& machine, Console& console) {
  if (options.save) {
    const auto store = FingerStore::of(finger);
    const MeasuringPresets presets = presets_to_save(study, machine);
    if (const Status saved = save_presets(*store, presets); !saved) return saved;
    std::vector<std::string> names;
    for (const MeasuringPreset& preset : presets.presets) names.push_back(preset.name);
    console.say(fmt::format("Saved with {}: {}.", finger.string(),
                            fmt::format("{}", fmt::join(names, ", "))));
    console.answer()["kept"] = names;
  }
  if (options.use == kWithin || options.use == kKeep) {
    const auto row = row_within(options, study);
    if (!row) return row.error();
    return use(finger, study.rows[row->first].settings, row->second, console);
  }
  if (options.save && !options.use.empty()) return use_stored_preset(finger, options.use, console);
  return {};
}

constexpr const char* kRowsFile = "study_rows.jsonl";
constexpr int kQuickFrames = 9, kFrames = 24;
constexpr int kQuickRepeats = 2, kRepeats = 3;

/// Rows that a study stores as they come, so that a stopped one can continue.
class SavedRows {
 public:
  /// `of`: what the rows depend on besides the settings; other rows are dropped.
  static Result<SavedRows> open(const Path& file, const std::string& of) {
    SavedRows saved(file);
    if (!std::filesystem::exists(file)) return saved.begin(of);
    const auto text = read_file(file);
    if (!text) return text.error();
    const std::size_t end = text->find('\n');
    if (end == std::string::npos || text->substr(0, end) != of) return saved.begin(of);
    auto rows = rows_of_lines(std::string_view(*text).substr(end + 1), file.string());
    if (!rows) return rows.error();
    saved.rows = std::move(rows).value();
    saved.of_ = of;
    return saved;
  }
  /// Replaces rows with the same settings.
  [[nodiscard]] Status add(const std::vector<StudyRow>& more) {
    for (const StudyRow& row : more) {
      const auto known = std::find_if(rows.begin(), rows.end(), [&](const StudyRow& saved) {
        return key_of(saved.settings) == key_of(row.settings);
      });
      if (known == rows.end())
        rows.push_back(row);
      else
        *known = row;
    }
    std::string text = of_ + '\n';
    for (const StudyRow& row : rows) text += line_of(row);
    return write_file_atomically(file_, text);
  }

  std::vector<StudyRow> rows;

 private:
  explicit SavedRows(Path file) : file_(std::move(file)) {}
  Result<SavedRows> begin(const std::string& of) {
    of_ = of;
    return *this;
  }

  Path file_;
  std::string of_;
};

class StudyCommand {
 public:
  StudyCommand(const StudyCommandOptions& options, Path folder, Console& console)
      : options_(options), folder_(std::move(folder)), console_(console) {
    console_.answer() = study_provenance(options);
    console_.answer()["studies"] = Console::Json::array();
  }

  Status run() {
    if (options_.fingers.empty()) return study_of({});
    if (uses_stored_preset(options_)) {
      for (const Path& finger : options_.fingers)
        if (const Status used = use_stored_preset(finger, options_.use, console_); !used)
          return used;
      return {};
    }
    for (const Path& finger : options_.fingers)
      if (const Status status = study_of(finger); !status) return status;
    return {};
  }

 private:
  // Empty: the demonstration's finger.
  Status study_of(const Path& finger_folder) {
    StudyWorldOptions world_options;
    world_options.frames = options_.quick ? kQuickFrames : kFrames;
    world_options.seed = options_.seed;
    world_options.threads = options_.threads;
    StudyOptions how;
    how.extent = options_.quick ? StudyExtent::kQuick : StudyExtent::kPairs;
    how.repeats = options_.quick ? kQuickRepeats : kRepeats;
    const auto world = world_of(finger_folder, world_options, how);
    if (!world) return world.error();
    const Path saved =
        folder_ / (finger_folder.empty() ? Path("simulated") : finger_folder.filename());
    if (const Status made = make_folder(saved); !made) return made;
    auto rows = SavedRows::open(saved / kRowsFile, fmt::format("{:016x} {} {}", world->checksum,
                                                               program_version(), how.repeats));
    if (!rows) return rows.error();
    const std::vector<StudyRow> known = rows->rows;
    auto study = study_accuracy(
        *world, how, known, [&](const std::vector<StudyRow>& more) { return rows->add(more); },
        console_.job());
    if (!study) return study.error();
    if (!finger_folder.empty())
      if (const Status held = hold_against_presses(finger_folder, *study, *rows); !held)
        return held;
    if (const Status printed = print_study(*study, how); !printed) return printed;
    if (const Status written = write(*study, saved); !written || finger_folder.empty())
      return written;
    const std::string machine = fmt::format("{}, {} thread{}", this_machine().processor,
                                            options_.threads, options_.threads > 1 ? "s" : "");
    return save_and_use(options_, *study, finger_folder, machine, console_);
  }

  /// A finger without presses, or with too few, gets no result here; the reason is printed.
  Status hold_against_presses(const Path& finger_folder, AccuracyStudy& study, SavedRows& rows) {
    const auto finger = open_finger(finger_folder, console_);
    if (!finger) return finger.error();
    const auto presses = RealPresses::open(*finger, console_.job());
    if (!presses) {
      console_.say(fmt::format("No real presses: {}", presses.error().sentence()));
      return {};
    }
    return add_real_errors(
        study, *presses, rows_for_real(study, !options_.quick),
        [&](const std::vector<StudyRow>& more) { return rows.add(more); }, console_.job());
  }

  Result<StudyWorld> world_of(const Path& finger_folder, const StudyWorldOptions& options,
                              StudyOptions& how) {
    if (finger_folder.empty()) return simulated_world(folder_, options, console_.job());
    const auto finger = open_finger(finger_folder, console_);
    if (!finger) return finger.error();
    how.base = calibrated_settings(finger_folder);
    return painted_world(*finger, options, console_.job());
  }

  Status print_study(const AccuracyStudy& study, const StudyOptions& how) {
    console_.say(fmt::format("{}, {} images ({} truth)", study.about, study.rows.front().frames,
                             study.simulated ? "simulated" : "painted"));
    console_.say(text_of(study));
    Console::Json json = Console::Json::parse(json_of(study).dump());
    const StudyPresets presets = presets_of(study);
    print_choice("fast", presets.fast, study, how, json);
    print_choice("finest", presets.finest, study, how, json);
    Status status;
    if (options_.max_time_ms)
      status = print_limit(fmt::format("within {} ms", *options_.max_time_ms),
                           most_accurate_within(study, *options_.max_time_ms, options_.position_mm),
                           study, how, json);
    if (status && options_.max_error_mm)
      status = print_limit(fmt::format("95 % within {} mm", *options_.max_error_mm),
                           fastest_within(study, *options_.max_error_mm, options_.position_mm),
                           study, how, json);
    console_.answer()["studies"].push_back(std::move(json));
    return status;
  }

  void print_choice(const std::string& name, std::optional<std::size_t> number,
                    const AccuracyStudy& study, const StudyOptions& how, Console::Json& json) {
    if (!number) return;
    const StudyRow& row = study.rows[*number];
    const std::string flags = flags_of(row.settings, how.base);
    console_.say(
        fmt::format("{}: {:.2f} ms, error {:.1f} micrometres (median), 95 % within {:.1f}: {}",
                    name, frame_ms(study, row), 1000 * row.depth->median_mm,
                    1000 * row.depth->p95_mm, flags.empty() ? "no change of settings" : flags));
    const StudyBalance balance = balance_of(study, row);
    if (!balance.loses.empty())
      console_.say(
          fmt::format("  losses against the current settings: {}", en::list(balance.loses)));
    if (!balance.brings.empty()) console_.say(fmt::format("  gains: {}", en::list(balance.brings)));
    json["choices"][name] = {{"flags", flags},
                             {"time_ms", frame_ms(study, row)},
                             {"median_mm", row.depth->median_mm},
                             {"p95_mm", row.depth->p95_mm},
                             {"loses", in_english(balance.loses)},
                             {"brings", in_english(balance.brings)}};
    if (row.position_mm) json["choices"][name]["place_mm"] = *row.position_mm;
  }

  Status print_limit(const std::string& name, std::optional<std::size_t> number,
                     const AccuracyStudy& study, const StudyOptions& how, Console::Json& json) {
    if (!number)
      return Error{en::say("no setting is {}", name), "",
                   en::say("a wider limit; the table above tells what there is")};
    print_choice(name, number, study, how, json);
    return {};
  }

  Status write(const AccuracyStudy& study, const Path& saved) {
    if (!options_.folder) return {};
    return write_study({json_of(study), csv_of(study), svg_of(study)}, study_provenance(options_),
                       saved, console_);
  }

  const StudyCommandOptions& options_;
  Path folder_;
  Console& console_;
};

/// Prints the time and the accuracy of every setting. An incomplete study in the folder is
/// continued. Error: those of study_accuracy(); nothing is within the given limits.
Status run_study(const StudyCommandOptions& options, Console& console) {
  set_opencv_threads(options.threads);
  if (options.calibrating) return run_calibrating_study(options, console);
  if (options.simulating) return run_simulating_study(options, console);
  if (options.scaling) return run_scaling_study(options, console);
  if (options.folder) {
    if (const Status made = make_folder(*options.folder); !made) return made;
    return StudyCommand(options, *options.folder, console).run();
  }
  const auto passing = ScopedFolder::make(en::say("a folder for the study cannot be made"));
  if (!passing) return passing.error();
  return StudyCommand(options, passing->path(), console).run();
}

}  // namespace

void add_study(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<StudyCommandOptions>();
  auto folder = std::make_shared<Path>();
  auto limits = std::make_shared<std::pair<double, double>>();
  auto position_limit = std::make_shared<double>();
  CLI::App* command = add_command(program, "study");
  command->add_option("FINGER", options->fingers,
                      "Finger whose recording supplies the images that balls are painted into "
                      "(default: the demonstration's finger, simulated)");
  CLI::Option* output = command
                            ->add_option("-o,--output", *folder,
                                         "Folder for figure, table and JSON; a stopped study "
                                         "continues there (default: not saved)")
                            ->type_name("DIR");
  command->add_flag("--quick", options->quick, "Varies one setting at a time, on few images");
  CLI::Option* calibrating =
      command->add_flag("--calibrating", options->calibrating,
                        "Studies what presses, images of each, methods, families and iterations "
                        "gain for a calibration, against minutes");
  CLI::Option* simulating =
      command
          ->add_flag("--simulating", options->simulating,
                     "Studies the cost and influence of each effect of a scene, which is given "
                     "instead of the finger (default: demo_presses)")
          ->excludes(calibrating);
  command
      ->add_flag(
          "--scaling", options->scaling,
          "Studies how time and memory grow with pixels, recorded frames (to 100000), markers, "
          "presses (to 200) and the length of recordings (to an hour), with exponents")
      ->excludes(calibrating)
      ->excludes(simulating);
  CLI::Option* within =
      command
          ->add_option("--within-ms", limits->first,
                       "Prints the most accurate settings within this time per frame, ms")
          ->type_name("MS")
          ->transform(typed_number(1e-3, 1e4));
  CLI::Option* keep =
      command
          ->add_option(
              "--keep-mm", limits->second,
              "Prints the fastest settings with 95 % of depth errors within this limit, mm")
          ->type_name("MM")
          ->transform(typed_number(1e-6, 100.0));
  CLI::Option* position_flag =
      command
          ->add_option("--place-mm", *position_limit,
                       "With both: maximum position error, mm (default: a quarter more than now)")
          ->type_name("MM")
          ->transform(typed_number(1e-6, 100.0));
  command->add_option("--seed", options->seed, "Seed of all random numbers (default 1)")
      ->type_name("S")
      ->transform(typed_integer(0));
  add_use_flags(*command, *options);
  add_threads_flag(*command, options->threads);
  command->callback([=, &chosen] {
    if (!output->empty()) options->folder = *folder;
    if (!within->empty()) options->max_time_ms = limits->first;
    if (!keep->empty()) options->max_error_mm = limits->second;
    if (!position_flag->empty()) options->position_mm = *position_limit;
    check_use_flags(*options);
    chosen = [=](Console& console) { return run_study(*options, console); };
  });
}

}  // namespace alltact
