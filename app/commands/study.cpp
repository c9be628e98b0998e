#include "app/commands/commands.h"
#include "app/commands/opencv_threads.h"
#include "app/commands/study_files.h"
#include "app/commands/study_use.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/console/number_flags.h"
#include "app/console/temporary_folder.h"
#include "calibration/experiments/simulated_world.h"
#include "calibration/finger/measuring_settings.h"
#include "calibration/study/real_presses.h"
#include "calibration/study/study_figure.h"
#include "calibration/study/study_file.h"
#include "calibration/study/study_machine.h"
#include "core/io/atomic_file.h"
#include "core/program.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

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
    auto rows = SavedRows::open(
        saved / kRowsFile,
        fmt::format("{:016x} {} {}", world->checksum, program_version(), how.repeats));
    if (!rows) return rows.error();
    const std::vector<StudyRow> known = rows->rows;
    auto study = study_accuracy(
        *world,
        how,
        known,
        [&](const std::vector<StudyRow>& more) { return rows->add(more); },
        console_.job());
    if (!study) return study.error();
    if (!finger_folder.empty())
      if (const Status held = hold_against_presses(finger_folder, *study, *rows); !held)
        return held;
    if (const Status printed = print_study(*study, how); !printed) return printed;
    if (const Status written = write(*study, saved); !written || finger_folder.empty())
      return written;
    const std::string machine = fmt::format("{}, {} thread{}",
                                            this_machine().processor,
                                            options_.threads,
                                            options_.threads > 1 ? "s" : "");
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
        study,
        *presses,
        rows_for_real(study, !options_.quick),
        [&](const std::vector<StudyRow>& more) { return rows.add(more); },
        console_.job());
  }

  Result<StudyWorld> world_of(const Path& finger_folder,
                              const StudyWorldOptions& options,
                              StudyOptions& how) {
    if (finger_folder.empty()) return simulated_world(folder_, options, console_.job());
    const auto finger = open_finger(finger_folder, console_);
    if (!finger) return finger.error();
    how.base = calibrated_settings(finger_folder);
    return painted_world(*finger, options, console_.job());
  }

  Status print_study(const AccuracyStudy& study, const StudyOptions& how) {
    console_.say(fmt::format("{}, {} pictures ({} truth)",
                             study.about,
                             study.rows.front().frames,
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
                           study,
                           how,
                           json);
    if (status && options_.max_error_mm)
      status = print_limit(fmt::format("95 % within {} mm", *options_.max_error_mm),
                           fastest_within(study, *options_.max_error_mm, options_.position_mm),
                           study,
                           how,
                           json);
    console_.answer()["studies"].push_back(std::move(json));
    return status;
  }

  void print_choice(const std::string& name,
                    std::optional<std::size_t> number,
                    const AccuracyStudy& study,
                    const StudyOptions& how,
                    Console::Json& json) {
    if (!number) return;
    const StudyRow& row = study.rows[*number];
    const std::string flags = flags_of(row.settings, how.base);
    console_.say(
        fmt::format("{}: {:.2f} ms, {:.1f} micrometres in the median, 95 % within {:.1f}: {}",
                    name,
                    frame_ms(study, row),
                    1000 * row.depth->median_mm,
                    1000 * row.depth->p95_mm,
                    flags.empty() ? "as it is" : flags));
    const StudyBalance balance = balance_of(study, row);
    if (!balance.loses.empty())
      console_.say(fmt::format("  against the one in use it loses: {}", en::list(balance.loses)));
    if (!balance.brings.empty())
      console_.say(fmt::format("  and brings: {}", en::list(balance.brings)));
    json["choices"][name] = {{"flags", flags},
                             {"time_ms", frame_ms(study, row)},
                             {"median_mm", row.depth->median_mm},
                             {"p95_mm", row.depth->p95_mm},
                             {"loses", in_english(balance.loses)},
                             {"brings", in_english(balance.brings)}};
    if (row.position_mm) json["choices"][name]["place_mm"] = *row.position_mm;
  }

  Status print_limit(const std::string& name,
                     std::optional<std::size_t> number,
                     const AccuracyStudy& study,
                     const StudyOptions& how,
                     Console::Json& json) {
    if (!number)
      return Error{en::say("no setting is {}", name),
                   "",
                   en::say("a wider limit; the table above tells what there is")};
    print_choice(name, number, study, how, json);
    return {};
  }

  Status write(const AccuracyStudy& study, const Path& saved) {
    if (!options_.folder) return {};
    return write_study({json_of(study), csv_of(study), svg_of(study)},
                       study_provenance(options_),
                       saved,
                       console_);
  }

  const StudyCommandOptions& options_;
  Path folder_;
  Console& console_;
};

}  // namespace

Status run_study(const StudyCommandOptions& options, Console& console) {
  set_opencv_threads(options.threads);
  if (options.calibrating) return run_calibrating_study(options, console);
  if (options.simulating) return run_simulating_study(options, console);
  if (options.scaling) return run_scaling_study(options, console);
  if (options.folder) {
    if (const Status made = make_folder(*options.folder); !made) return made;
    return StudyCommand(options, *options.folder, console).run();
  }
  const auto passing = TemporaryFolder::make(en::say("a folder for the study cannot be made"));
  if (!passing) return passing.error();
  return StudyCommand(options, passing->path(), console).run();
}

void add_study(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<StudyCommandOptions>();
  auto folder = std::make_shared<Path>();
  auto limits = std::make_shared<std::pair<double, double>>();
  auto position_limit = std::make_shared<double>();
  CLI::App* command = add_command(program, "study");
  command->add_option("FINGER",
                      options->fingers,
                      "Balls are painted into pictures of its own recording (default: the "
                      "demonstration's finger, simulated)");
  CLI::Option* output =
      command
          ->add_option("-o,--output",
                       *folder,
                       "Folder for figure, table and JSON; a study that was stopped goes on there "
                       "(default: kept nowhere)")
          ->type_name("DIR");
  command->add_flag("--quick", options->quick, "One setting at a time, on few pictures");
  CLI::Option* calibrating =
      command->add_flag("--calibrating",
                        options->calibrating,
                        "What presses, pictures of each, methods, families and iterations bring to "
                        "a calibration, against minutes");
  CLI::Option* simulating =
      command
          ->add_flag("--simulating",
                     options->simulating,
                     "What each effect of a scene costs and changes; a scene takes the finger's "
                     "place (default: demo_presses)")
          ->excludes(calibrating);
  command
      ->add_flag("--scaling",
                 options->scaling,
                 "How time and memory grow with pixels, recorded frames (to 100000), markers and "
                 "presses (to 200) and the length of recordings (to an hour), with exponents")
      ->excludes(calibrating)
      ->excludes(simulating);
  CLI::Option* within =
      command
          ->add_option(
              "--within-ms", limits->first, "Also say what is most accurate in so much time")
          ->type_name("MS")
          ->transform(typed_number(1e-3, 1e4));
  CLI::Option* keep = command
                          ->add_option("--keep-mm",
                                       limits->second,
                                       "Also say what is fastest with 95 % of depth within so much")
                          ->type_name("MM")
                          ->transform(typed_number(1e-6, 100.0));
  CLI::Option* position_flag =
      command
          ->add_option("--place-mm",
                       *position_limit,
                       "With both: how far off places may be told (default: a quarter more than "
                       "now)")
          ->type_name("MM")
          ->transform(typed_number(1e-6, 100.0));
  command->add_option("--seed", options->seed, "Of everything random (default 1)")
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
