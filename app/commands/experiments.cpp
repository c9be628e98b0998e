#include "calibration/experiments/experiments.h"

#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/figures/figures.h"
#include "core/base/atomic_file.h"
#include "core/base/cache.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "core/sensing/frame_result.h"

#include <cmath>

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

struct ExperimentsOptions {
  std::vector<std::string> names;  ///< none: all
  std::optional<Path> folder;  ///< for the fingers and experiments.json; empty: nothing is stored
  std::optional<Path> report;  ///< NAME.html; NAME.pdf goes next to it
  bool fresh = false;          ///< no finger of an earlier run, and none for a later one
  std::uint64_t seed = 1;
  int threads = 2;
};

constexpr const char* kExperimentsFile = "experiments.json";

double seconds_of(const StopWatch& watch) {
  double milliseconds = 0;
  watch.total(milliseconds);
  return milliseconds / 1000;
}

std::string number_or_dash(const std::optional<double>& number) {
  return number ? fmt::format("{:g}", *number) : "-";
}

void print_outcome(const Experiment& experiment, const ExperimentOutcome& outcome, double seconds,
                   Console& console) {
  console.say(fmt::format("\n{}: {} ({} frames, {:.1f} s)", experiment.name, experiment.measures,
                          outcome.frames, seconds));
  for (const ExperimentFigure& figure : outcome.figures)
    console.say(fmt::format("  {:<58} {:>9} {:>9} {:>7}  {:<7}{}", figure.what.english(),
                            fmt::format("{:.3f}", figure.simulated), number_or_dash(figure.paper),
                            number_or_dash(figure.aim), figure.unit,
                            figure.reaches_aim() ? "" : "  misses the target"));
  for (const Message& remark : outcome.remarks) console.say(fmt::format("  {}.", remark));
}

Console::Json json_of_plot(const ExperimentPlot& plot) {
  Console::Json json{{"caption", plot.caption.english()},
                     {"x", plot.x_axis.english()},
                     {"y", plot.y_axis.english()}};
  if (!plot.categories.empty()) json["categories"] = in_english(plot.categories);
  Console::Json& all = json["series"] = Console::Json::array();
  for (const ExperimentSeries& series : plot.series)
    all.push_back({{"name", series.name.english()},
                   {"of_the_paper", series.style == ExperimentSeries::Style::kPaper},
                   {"x", series.x},
                   {"y", series.y}});
  return json;
}

/// The maps of a report without their pixels: for each method the error of the shown map.
Console::Json json_of_maps(const std::vector<ExperimentMaps>& all) {
  Console::Json json = Console::Json::array();
  for (const ExperimentMaps& maps : all) {
    Console::Json entry{{"caption", maps.caption.english()}};
    for (const ExperimentMap& difference : maps.differences) {
      const cv::Mat valid = difference.mm == difference.mm;  // false for NaN
      entry["differences"].push_back(
          {{"name", difference.name.english()},
           {"rms_mm", cv::norm(difference.mm, cv::NORM_L2, valid) /
                          std::sqrt(cv::countNonZero(valid) + 1e-9)},
           {"told_percent", 100.0 * cv::countNonZero(valid) / static_cast<double>(valid.total())}});
    }
    json.push_back(std::move(entry));
  }
  return json;
}

Console::Json json_of_outcome(const Experiment& experiment, const ExperimentOutcome& outcome,
                              double seconds) {
  Console::Json json;
  json["experiment"] = experiment.name;
  json["measures"] = experiment.measures.english();
  json["scenes"] = experiment.scenes;
  json["frames"] = outcome.frames;
  json["seconds"] = seconds;
  Console::Json& figures = json["figures"] = Console::Json::array();
  for (const ExperimentFigure& figure : outcome.figures) {
    Console::Json entry{
        {"what", figure.what.english()}, {"unit", figure.unit}, {"ours", figure.simulated}};
    if (figure.paper) entry["paper"] = *figure.paper;
    if (figure.aim) {
      entry["aim"] = *figure.aim;
      entry["reaches_aim"] = figure.reaches_aim();
    }
    figures.push_back(std::move(entry));
  }
  json["remarks"] = in_english(outcome.remarks);
  Console::Json& plots = json["plots"] = Console::Json::array();
  for (const ExperimentPlot& plot : outcome.plots) plots.push_back(json_of_plot(plot));
  if (!outcome.maps.empty()) json["maps"] = json_of_maps(outcome.maps);
  return json;
}

void print_finger(const ExperimentBench& bench, double seconds, Console& console) {
  if (bench.finger_was_cached()) {
    console.say(fmt::format(
        "The shared finger was loaded from the cache in {:.1f} s (--fresh simulates it again).\n",
        seconds));
    return;
  }
  console.say(fmt::format(
      "The shared finger was simulated and calibrated in {:.1f} s{}.\n", seconds,
      bench.options().cache && !bench.cache_problem() ? " and cached for the next run" : ""));
  if (bench.cache_problem()) console.warn(bench.cache_problem()->sentence());
}

Result<ExperimentReport> run_in_folder(const std::vector<const Experiment*>& chosen,
                                       const BenchOptions& options, Console& console) {
  const StopWatch making;
  const auto bench = ExperimentBench::make(options, console.job());
  if (!bench) return bench.error();
  console.say(simulated_and_real().english());
  print_finger(*bench, seconds_of(making), console);
  console.say(fmt::format("  {:<58} {:>9} {:>9} {:>7}", "", "ours", "paper's", "target"));
  Console::Json& answer = console.answer();
  answer["about"] = simulated_and_real().english();
  answer["seed"] = options.seed;
  answer["finger_seconds"] = seconds_of(making);
  answer["finger_was_kept"] = bench->finger_was_cached();
  Console::Json& all = answer["experiments"] = Console::Json::array();
  ExperimentReport report;
  report.seed = options.seed;
  report.date = utc_now();
  report.program_version = program_version();
  for (const Experiment* experiment : chosen) {
    const StopWatch running;
    auto outcome = experiment->run(*bench);
    if (!outcome) return outcome.error();
    const double seconds = seconds_of(running);
    print_outcome(*experiment, *outcome, seconds, console);
    all.push_back(json_of_outcome(*experiment, *outcome, seconds));
    report.done.push_back({experiment, std::move(*outcome), seconds});
  }
  return report;
}

Status write_report(const ExperimentReport& report, const Path& file, Console& console) {
  const auto drawing = load_figures();
  if (!drawing) return drawing.error();
  const auto pages = (*drawing)->experiment_pages(report, file.stem().string());
  if (!pages) return pages.error();
  for (const ReportFile& page : *pages) {
    const Status written = write_file_atomically(file.parent_path() / page.name, page.content);
    if (!written) return written;
  }
  console.say(fmt::format("\nReport: {}, .pdf", file.string()));
  console.answer()["report"] = file.string();
  return {};
}

Status run_and_report(const std::vector<const Experiment*>& chosen, const BenchOptions& bench,
                      const ExperimentsOptions& options, Console& console) {
  const auto report = run_in_folder(chosen, bench, console);
  if (!report) return report.error();
  if (options.report) return write_report(*report, *options.report, console);
  return {};
}

/// Finds errors that can be known before minutes have passed.
Status check_report(const Path& file) {
  if (file.extension() != ".html")
    return Error{en::say("this is no name for a report"), file, en::say("a name ending in .html")};
  std::error_code failed;
  const Path folder = file.parent_path().empty() ? Path(".") : file.parent_path();
  if (!std::filesystem::is_directory(folder, failed))
    return Error{en::say("the folder of the report is not there"), folder, en::say("making it")};
  const auto drawing = load_figures();
  return drawing ? Status() : drawing.error();
}

/// Repeats the source paper's experiments in simulation and prints the results next to the paper's.
/// Error: no such experiment; one of them gave no figure.
Status run_experiments(const ExperimentsOptions& options, Console& console) {
  const auto chosen = experiments_named(options.names);
  if (!chosen) return chosen.error();
  if (options.report)
    if (const Status possible = check_report(*options.report); !possible) return possible;
  set_opencv_threads(options.threads);
  BenchOptions bench;
  bench.seed = options.seed;
  bench.threads = options.threads;
  if (!options.fresh) bench.cache = cache_folder("fingers");
  if (!options.folder) {
    const auto passing =
        ScopedFolder::make(en::say("a folder for the simulated fingers cannot be made"));
    if (!passing) return passing.error();
    bench.folder = passing.value().path();
    return run_and_report(*chosen, bench, options, console);
  }
  bench.folder = *options.folder;
  if (const Status made = make_folder(bench.folder); !made) return made;
  const Status status = run_and_report(*chosen, bench, options, console);
  if (!status) return status;
  const Path file = bench.folder / kExperimentsFile;
  const Status written = write_file_atomically(file, console.answer().dump(2) + "\n");
  if (!written) return written;
  console.say(fmt::format("\nThese figures are in {}.", file.string()));
  return {};
}

}  // namespace

void add_experiments(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ExperimentsOptions>();
  auto folder = std::make_shared<Path>();
  CLI::App* command = add_command(program, "experiments");
  std::string names;
  for (const Experiment& experiment : experiments())
    names += (names.empty() ? "" : ", ") + experiment.name;
  command->add_option("NAME", options->names,
                      fmt::format("Names of the experiments to run (default all): {}", names));
  CLI::Option* output =
      command
          ->add_option("-o,--output", *folder,
                       "Folder for experiments.json and the simulated fingers (default: not saved)")
          ->type_name("DIR");
  auto report = std::make_shared<Path>();
  CLI::Option* pages =
      command
          ->add_option(
              "--report", *report,
              "Writes a report with plots, ours next to the paper's: FILE.html and FILE.pdf")
          ->type_name("FILE.html");
  command->add_flag("--fresh", options->fresh,
                    "Simulates the fingers again and does not cache them (default: cached in "
                    "alltact/fingers of $XDG_CACHE_HOME or ~/.cache)");
  command->add_option("--seed", options->seed, "Seed of all random numbers (default 1)")
      ->type_name("S")
      ->transform(typed_integer(0));
  command
      ->add_option("--threads", options->threads,
                   "Number of threads (1 to 64; default 2); the figures do not depend on it")
      ->type_name("N")
      ->transform(typed_integer(1, 64));
  command->callback([=, &chosen] {
    if (!output->empty()) options->folder = *folder;
    if (!pages->empty()) options->report = *report;
    chosen = [=](Console& console) { return run_experiments(*options, console); };
  });
}

}  // namespace alltact
