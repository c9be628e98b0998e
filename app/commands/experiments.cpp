#include "calibration/experiments/experiments.h"

#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/console/passing_folder.h"
#include "core/io/atomic_file.h"

#include <chrono>

#include <fmt/format.h>
#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

constexpr const char* kExperimentsFile = "experiments.json";
constexpr const char* kOursAndTheirs =
    "Ours are simulated, with the truth known; the paper's were measured on a real finger.";

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

std::string number_or_dash(const std::optional<double>& number) {
  return number ? fmt::format("{:.3f}", *number) : "-";
}

void tell_outcome(const Experiment& experiment,
                  const ExperimentOutcome& outcome,
                  double seconds,
                  Console& console) {
  console.say(fmt::format("\n{}: {} ({} frames, {:.1f} s)",
                          experiment.name,
                          experiment.measures,
                          outcome.frames,
                          seconds));
  for (const ExperimentFigure& figure : outcome.figures)
    console.say(fmt::format("  {:<58} {:>9} {:>9} {:>7}  {:<7}{}",
                            figure.what.english(),
                            number_or_dash(figure.ours),
                            number_or_dash(figure.paper),
                            number_or_dash(figure.aim),
                            figure.unit,
                            figure.reaches_aim() ? "" : "  misses the aim"));
  for (const Message& remark : outcome.remarks) console.say(fmt::format("  {}.", remark));
}

Console::Json json_of_outcome(const Experiment& experiment,
                              const ExperimentOutcome& outcome,
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
        {"what", figure.what.english()}, {"unit", figure.unit}, {"ours", figure.ours}};
    if (figure.paper) entry["paper"] = *figure.paper;
    if (figure.aim) {
      entry["aim"] = *figure.aim;
      entry["reaches_aim"] = figure.reaches_aim();
    }
    figures.push_back(std::move(entry));
  }
  json["remarks"] = in_english(outcome.remarks);
  return json;
}

Status run_in_folder(const std::vector<const Experiment*>& chosen,
                     const BenchOptions& options,
                     Console& console) {
  const Stopwatch making;
  const auto bench = ExperimentBench::make(options, console.job());
  if (!bench) return bench.error();
  console.say(kOursAndTheirs);
  console.say(fmt::format("The finger they share was recorded and calibrated in {:.1f} s.\n",
                          making.seconds()));
  console.say(fmt::format("  {:<58} {:>9} {:>9} {:>7}", "", "ours", "paper's", "aim"));
  Console::Json& answer = console.answer();
  answer["about"] = kOursAndTheirs;
  answer["seed"] = options.seed;
  answer["finger_seconds"] = making.seconds();
  Console::Json& all = answer["experiments"] = Console::Json::array();
  for (const Experiment* experiment : chosen) {
    const Stopwatch running;
    const auto outcome = experiment->run(*bench);
    if (!outcome) return outcome.error();
    const double seconds = running.seconds();
    tell_outcome(*experiment, *outcome, seconds, console);
    all.push_back(json_of_outcome(*experiment, *outcome, seconds));
  }
  return {};
}

}  // namespace

Status run_experiments(const ExperimentsOptions& options, Console& console) {
  const auto chosen = experiments_named(options.names);
  if (!chosen) return chosen.error();
  cv::setNumThreads(options.threads);
  BenchOptions bench;
  bench.seed = options.seed;
  bench.threads = options.threads;
  if (!options.folder) {
    const auto passing =
        PassingFolder::make(en::say("a folder for the simulated fingers cannot be made"));
    if (!passing) return passing.error();
    bench.folder = passing.value().path();
    return run_in_folder(*chosen, bench, console);
  }
  bench.folder = *options.folder;
  if (const Status made = make_folder(bench.folder); !made) return made;
  if (const Status status = run_in_folder(*chosen, bench, console); !status) return status;
  const Path file = bench.folder / kExperimentsFile;
  const Status written = write_file_atomically(file, console.answer().dump(2) + "\n");
  if (!written) return written;
  console.say(fmt::format("\nThese figures are in {}.", file.string()));
  return {};
}

void add_experiments(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ExperimentsOptions>();
  auto folder = std::make_shared<Path>();
  CLI::App* command = add_command(program, "experiments");
  std::string names;
  for (const Experiment& experiment : experiments())
    names += (names.empty() ? "" : ", ") + experiment.name;
  command->add_option("NAME", options->names, fmt::format("Only these (default all): {}", names));
  CLI::Option* output =
      command
          ->add_option(
              "-o,--output",
              *folder,
              "Folder for experiments.json and the simulated fingers (default: kept nowhere)")
          ->type_name("DIR");
  command->add_option("--seed", options->seed, "Of everything random (default 1)")->type_name("S");
  add_threads_flag(*command, options->threads);
  command->callback([=, &chosen] {
    if (!output->empty()) options->folder = *folder;
    chosen = [=](Console& console) { return run_experiments(*options, console); };
  });
}

}  // namespace alltact
