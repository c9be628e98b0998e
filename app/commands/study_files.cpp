#include "app/commands/study_files.h"

#include "app/console/flags.h"
#include "app/console/temporary_folder.h"
#include "app/figures/figures.h"
#include "calibration/experiments/experiment_bench.h"
#include "calibration/experiments/simulating_study.h"
#include "calibration/study/calibrating_study.h"
#include "calibration/study/scaling_study.h"
#include "calibration/study/study_figure.h"
#include "calibration/study/study_machine.h"
#include "core/io/atomic_file.h"
#include "core/program.h"
#include "core/utc_time.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

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
Status add_figures(const std::string& svg,
                   const Console::Json& provenance,
                   std::vector<ReportFile>& all,
                   Console& console) {
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
Status publish_study(const Study& study,
                     const std::string& svg,
                     const std::string& name,
                     const StudyCommandOptions& options,
                     Console& console) {
  console.say(text_of(study));
  console.answer()["studies"].push_back(Console::Json::parse(json_of(study).dump()));
  if (!options.folder) return {};
  const Path folder = *options.folder / name;
  if (const Status made = make_folder(folder); !made) return made;
  return write_study(
      {json_of(study), csv_of(study), svg}, study_provenance(options), folder, console);
}

/// The demonstration's finger, which measures all that a study needs.
Result<FingerPtr> simulated_finger(const StudyCommandOptions& options,
                                   const Path& folder,
                                   Console& console) {
  BenchOptions bench_options;
  bench_options.folder = folder;
  bench_options.seed = options.seed;
  bench_options.threads = options.threads;
  const auto bench = ExperimentBench::make(bench_options, console.job());
  if (!bench) return bench.error();
  return open_finger(bench->finger().folder);
}

}  // namespace

Console::Json study_provenance(const StudyCommandOptions& options) {
  Console::Json json{{"program", program_version()}, {"date", utc_now()}};
  json["machine"] = Console::Json::parse(json_of(this_machine()).dump());
  json["threads"] = options.threads;
  json["seed"] = options.seed;
  return json;
}

Status write_study(const StudyFiles& files,
                   const Console::Json& provenance,
                   const Path& folder,
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
  console.say(fmt::format("Kept in {}: {}.", folder.string(), names));
  return {};
}

Status run_calibrating_study(const StudyCommandOptions& options, Console& console) {
  if (options.fingers.empty())
    return Error{en::say("no finger was named whose calibration is to be studied"),
                 "",
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
  const auto passing = TemporaryFolder::make(en::say("a folder for the study cannot be made"));
  if (!passing) return passing.error();
  const auto finger = simulated_finger(options, passing->path(), console);
  if (!finger) return finger.error();
  SimulatingOptions how;
  how.seed = options.seed;
  how.frames = options.quick ? kQuickSceneFrames : kSceneFrames;
  const auto study = study_simulating(*scene, *finger, how, console.job());
  if (!study) return study.error();
  console.say(fmt::format("{}, {} pictures (simulated)", study->scene, study->rows.front().frames));
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
    const auto passing = TemporaryFolder::make(en::say("a folder for the study cannot be made"));
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

}  // namespace alltact
