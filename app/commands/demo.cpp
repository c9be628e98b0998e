#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/study/evaluate.h"
#include "core/base/atomic_file.h"
#include "core/base/program.h"

#include <cstdlib>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <unistd.h>

namespace alltact {
namespace {

struct DemoOptions {
  Path folder;
  bool studio = false;  ///< the finger alone, and the Studio instead of this program
  std::uint64_t seed = 1;
  int threads = 1;
};

namespace fs = std::filesystem;

/// One of the two methods, each with a finger of its own.
struct Contender {
  std::string name;  ///< as --method names it
  Path finger;
  Path results;
  CalibrationMethod calibration;
  Evaluation evaluation;
};

class Demo {
 public:
  Demo(const DemoOptions& options, Console& console)
      : options_(options),
        console_(console),
        contenders_{{"ours", folder("finger"), folder("results"), CalibrationMethod::kJoint, {}},
                    {"paper",
                     folder("paper/finger"),
                     folder("paper/results"),
                     CalibrationMethod::kPaper,
                     {}}} {}

  /// The finger alone, calibrated; an existing one is used again.
  Status make_calibrated_finger() {
    const auto there = FingerStore::of(folder("finger"))->snapshot();
    if (there && (*there)->mapping) return {};
    contenders_.pop_back();
    scenes_ = {"reference", "presses"};
    for (const auto step : {&Demo::simulate, &Demo::make_finger, &Demo::calibrate}) {
      if (console_.job().stop_requested())
        return Error{en::say("stopped before the finger was calibrated"), "", ""};
      if (const Status status = (this->*step)(); !status) return status;
    }
    return {};
  }

  Status run() {
    for (const auto step : {&Demo::simulate, &Demo::make_finger, &Demo::calibrate,
                            &Demo::reconstruct, &Demo::compare}) {
      if (console_.job().stop_requested())
        return Error{en::say("stopped before the demonstration was over"), "", ""};
      if (const Status status = (this->*step)(); !status) return status;
    }
    print_results();
    return write_report();
  }

 private:
  [[nodiscard]] Path folder(const char* name) const { return options_.folder / name; }
  void headline(std::string_view line) { console_.say(fmt::format("\n== {}", line)); }

  Status simulate() {
    headline("Simulated finger: bent without contact, pressed by a ball, in contact with objects");
    for (const char* name : scenes_) {
      const auto scene = find_resource(fmt::format("scenes/demo_{}.yaml", name));
      if (!scene) return scene.error();
      SimulateOptions simulation;
      simulation.scene = *scene;
      simulation.folder = folder(name);
      simulation.seed = options_.seed;
      simulation.video = std::string_view(name) == "reference";
      simulation.threads = options_.threads;
      if (const Status status = run_simulate(simulation, console_); !status) return status;
    }
    return {};
  }

  Status make_finger() {
    headline("Finger folder and reference recording");
    const auto text = read_file(folder("reference/truth.json"));
    if (!text) return text.error();
    const auto finger = Console::Json::parse(*text).at("finger");
    NewFinger description;
    description.finger = contenders_.front().finger;
    description.name = "demo";
    description.camera = folder("reference/camera.yaml");
    description.width_mm = finger.at("width_mm");
    description.layer_mm = finger.at("layer_mm");
    description.per_row = finger.at("per_row");
    std::error_code failed;  // fingers of an earlier demonstration, made here below its own folder
    for (const Contender& contender : contenders_) fs::remove_all(contender.finger, failed);
    if (const Status status = run_new(description, console_); !status) return status;
    const Status status =
        run_reference({description.finger, {folder("reference/frames.mkv")}, {}}, console_);
    if (!status) return status;
    if (contenders_.size() == 1) return {};
    if (const Status made = make_folder(folder("paper")); !made) return made;
    fs::copy(description.finger, contenders_.back().finger, fs::copy_options::recursive, failed);
    if (failed)
      return Error{Message::typed(failed.message()), contenders_.back().finger.string(),
                   en::say("free space and permission")};
    return {};
  }

  Status calibrate() {
    const auto text = read_file(folder("presses/truth.json"));
    if (!text) return text.error();
    const auto truth = Console::Json::parse(*text);
    CalibrateOptions calibration;
    calibration.presses.files = {folder("presses")};
    calibration.ball_radius_mm = truth.at("frames").at(0).at("ball").at("radius_mm");
    for (const Contender& contender : contenders_) {
      headline(fmt::format("Calibration with the ball presses, method {}", contender.name));
      calibration.finger = contender.finger;
      calibration.calibration.method = contender.calibration;
      if (const Status status = run_calibrate(calibration, console_); !status) return status;
    }
    return {};
  }

  Status reconstruct() {
    for (const Contender& contender : contenders_) {
      headline(fmt::format("Reconstruction of the objects, method {}", contender.name));
      ReconstructOptions reconstruction;
      reconstruction.finger = contender.finger;
      reconstruction.inputs = {folder("objects")};
      reconstruction.folder = contender.results;
      reconstruction.points = true;  // the face out of contact is compared as well
      reconstruction.as_paper = contender.calibration == CalibrationMethod::kPaper;
      std::error_code failed;  // results of an earlier demonstration
      fs::remove_all(contender.results, failed);
      if (const Status status = run_reconstruct(reconstruction, console_); !status) return status;
    }
    return {};
  }

  Status compare() {
    for (Contender& contender : contenders_) {
      auto evaluation = evaluate_folder(folder("objects"), contender.results);
      if (!evaluation) return evaluation.error();
      contender.evaluation = *evaluation;
    }
    return {};
  }

  struct Row {
    const char* key;
    const char* words;
    std::optional<double> Evaluation::*value;
    const char* format;
  };
  static constexpr Row kRows[] = {
      {"contact_depth_mm", "depth inside contacts, mean error", &Evaluation::contact_depth_mm,
       "{:.4f} mm"},
      {"contact_coverage", "contact pixels that have a depth", &Evaluation::contact_coverage,
       "{:.4f}"},
      {"false_depth_mm", "depth outside contacts, mean", &Evaluation::false_depth_mm, "{:.4f} mm"},
      {"position_mm", "position of the untouched face, median error", &Evaluation::position_mm,
       "{:.4f} mm"},
      {"marker_seen_px", "visible markers, mean error", &Evaluation::marker_seen_px, "{:.3f} px"},
      {"marker_hidden_px", "hidden markers, mean error", &Evaluation::marker_hidden_px,
       "{:.3f} px"},
      {"time_ms", "time per frame, median", &Evaluation::time_ms, "{:.2f} ms"},
  };

  void print_results() {
    headline(fmt::format("Results against the truth of {} simulated frames",
                         contenders_.front().evaluation.frames));
    console_.say(
        fmt::format("{:<46} {:>12} {:>12}", "", contenders_.front().name, contenders_.back().name));
    for (const Row& row : kRows) {
      std::string line = fmt::format("{:<46}", row.words);
      for (const Contender& contender : contenders_) {
        const auto value = contender.evaluation.*row.value;
        line += fmt::format(" {:>12}", value ? fmt::format(fmt::runtime(row.format), *value) : "-");
      }
      console_.say(line);
    }
    console_.say(
        "'paper' is the source paper's full method, from its own edge detection to its own "
        "calibration, on the same images.");
    console_.say(
        fmt::format("\nFinger: {}\nDepth of every frame (float TIFF, mm): {}\nThese figures: {}",
                    contenders_.front().finger.string(), contenders_.front().results.string(),
                    folder("report.json").string()));
  }

  Status write_report() {
    Console::Json report;
    report["seed"] = options_.seed;
    for (const Contender& contender : contenders_) {
      Console::Json& entry = report[contender.name];
      entry["frames"] = contender.evaluation.frames;
      entry["frames_missing"] = contender.evaluation.frames_missing;
      for (const Row& row : kRows)
        if (const auto value = contender.evaluation.*row.value) entry[row.key] = *value;
    }
    console_.answer() = report;
    console_.answer()["report"] = folder("report.json").string();
    return write_file_atomically(folder("report.json"), report.dump(2) + "\n");
  }

  const DemoOptions& options_;
  Console& console_;
  std::vector<Contender> contenders_;
  std::vector<const char*> scenes_{"reference", "presses", "objects"};
};

/// The platform for windows from this program's environment: drawing a report overwrites it.
class SavedPlatform {
 public:
  SavedPlatform() {
    if (const char* env_value = std::getenv(kName)) env_value_ = env_value;
  }
  void restore() const {
    if (env_value_)
      setenv(kName, env_value_->c_str(), 1);
    else
      unsetenv(kName);
  }

 private:
  static constexpr const char* kName = "QT_QPA_PLATFORM";
  std::optional<std::string> env_value_;
};

/// Becomes the Studio, on a simulated finger that the calibrated one measures; returns only with an
/// error.
Status become_studio(const Path& finger) {
  std::error_code failed;
  const Path programs = fs::read_symlink("/proc/self/exe", failed).parent_path();
  const auto scene = find_resource("scenes/studio_finger.yaml");
  if (!scene) return scene.error();
  // Next to this program, or where the build leaves it.
  for (const Path& studio : {programs / "alltact-studio", programs / "studio/alltact-studio"}) {
    if (!fs::is_regular_file(studio, failed)) continue;
    const std::string name = studio.string(), folder = finger.string(), source = scene->string();
    execl(name.c_str(), name.c_str(), folder.c_str(), "--source", source.c_str(), nullptr);
  }
  return Error{en::say("the Studio is not installed"), (programs / "alltact-studio").string(),
               en::say("installing alltact-studio")};
}

/// A full day of a simulated finger, with its measurements against the truth. With `studio` it
/// returns only where that cannot be opened.
Status run_demo(const DemoOptions& options, Console& console) {
  if (!options.studio) return Demo(options, console).run();
  const SavedPlatform platform;
  const Status made = Demo(options, console).make_calibrated_finger();
  platform.restore();
  return made ? become_studio(options.folder / "finger") : made;
}

}  // namespace

void add_demo(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<DemoOptions>();
  CLI::App* command = add_command(program, "demo");
  command->add_option("-o,--output", options->folder, "Folder for all files")
      ->type_name("DIR")
      ->required();
  command->add_flag(
      "--studio", options->studio,
      "Only makes and calibrates the finger, unless it exists, and opens it in the Studio");
  command->add_option("--seed", options->seed, "Seed of all random numbers (default 1)")
      ->type_name("S")
      ->transform(typed_integer(0));
  add_threads_flag(*command, options->threads);
  command->callback(
      [=, &chosen] { chosen = [=](Console& console) { return run_demo(*options, console); }; });
}

}  // namespace alltact
