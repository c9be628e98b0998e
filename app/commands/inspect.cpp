// Inspects a recording by a recipe that was made in the window or written by hand.
#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "app/figures/figures.h"
#include "calibration/live/inspect_recording.h"
#include "core/base/atomic_file.h"
#include "core/base/utc_time.h"

#include <memory>
#include <optional>

#include <fmt/format.h>

namespace alltact {
namespace {

struct InspectCommand {
  InspectionOrder order;
  Path recipe, output;
  std::optional<Path> report;
  bool each = false;
};

Console::Json reading_json(const RecipeReading& reading, const ReadingSummary& summary) {
  Console::Json json{{"reading", reading.name},        {"what", to_string(reading.what)},
                     {"unit", unit_of(reading.what)},  {"measured", summary.measured},
                     {"passed", summary.passed},       {"failed", summary.failed},
                     {"undecided", summary.undecided}, {"mean", json_of(summary.mean)},
                     {"sd", json_of(summary.sd)},      {"min", json_of(summary.min)},
                     {"max", json_of(summary.max)}};
  if (summary.trend) {
    json["trend"] = summary.trend->value;
    json["trend_sd"] = summary.trend->sd;
    json["trend_per"] = summary.is_trend_per_second ? "s" : "frame";
  }
  return json;
}

void print_log(const InspectionLog& log, Console& console) {
  const auto text = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4f}", *value) : std::string("-");
  };
  console.say(fmt::format("{:<24} {:<10} {:>5} {:>10} {:>9} {:>10} {:>10} {:>6} {:>6} {:>9}",
                          "reading", "what", "unit", "mean", "sd", "min", "max", "pass", "fail",
                          "undecided"));
  Console::Json rows = Console::Json::array();
  const auto summaries = log.summaries();
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    const RecipeReading& reading = log.recipe.readings[i];
    const ReadingSummary& one = summaries[i];
    console.say(fmt::format("{:<24} {:<10} {:>5} {:>10} {:>9} {:>10} {:>10} {:>6} {:>6} {:>9}",
                            reading.name, to_string(reading.what), unit_of(reading.what),
                            text(one.mean), text(one.sd), text(one.min), text(one.max), one.passed,
                            one.failed, one.undecided));
    if (one.measured < log.rows.size())
      console.warn(fmt::format("{}: {} of {} frames could not be read; the log has the reasons.",
                               reading.name, log.rows.size() - one.measured, log.rows.size()));
    rows.push_back(reading_json(reading, one));
  }
  console.answer()["frames"] = log.rows.size();
  console.answer()["readings"] = std::move(rows);
  console.answer()["verdict"] = to_string(log.verdict());
}

Status write_report(const InspectionLog& log, const InspectionOrder& order, const Path& file,
                    Console& console) {
  const auto drawing = load_figures();
  if (!drawing) return drawing.error();
  const auto pdf = (*drawing)->inspection_report(log, order, utc_now());
  if (!pdf) return pdf.error();
  if (const Status written = write_file_atomically(file, *pdf); !written) return written;
  console.answer()["report"] = file.string();
  console.say(fmt::format("Report to sign: {}", file.string()));
  return {};
}

/// The error of a verdict that is no pass.
Status status_of(Conformity verdict, const Path& output) {
  switch (verdict) {
    case Conformity::kFail:
      return Error{en::say("readings are outside of their tolerance"), output, ""};
    case Conformity::kUndecided:
    case Conformity::kNotMeasured:
      return Error{en::say("it is not certain that all readings are within their tolerances"),
                   output, en::say("a reading with a smaller uncertainty")};
    case Conformity::kPass:
    case Conformity::kNoTolerance:
      break;
  }
  return {};
}

/// Error: a recording could not be inspected, or as status_of() the worst.
Status run_each(const InspectCommand& command, const InspectionOrder& order, Console& console) {
  const auto recordings = inspect_recordings(order, console.job());
  if (!recordings) return recordings.error();
  if (const Status written = write_file_atomically(command.output, csv_of(*recordings)); !written)
    return written;
  Console::Json rows = Console::Json::array();
  std::size_t failed = 0;
  Status worst;
  for (const InspectedRecording& one : *recordings) {
    const std::string verdict(one.log ? to_string(one.log->verdict()) : "");
    rows.push_back({{"recording", one.recording.string()}, {"verdict", verdict}});
    if (!one.log) {
      ++failed;
      console.warn(fmt::format("{}: {}", one.recording.string(), one.problem.english()));
      continue;
    }
    console.say(fmt::format("{}: {} frames{}", one.recording.string(), one.log->rows.size(),
                            verdict.empty() ? "" : ", " + verdict));
    if (const Status status = status_of(one.log->verdict(), command.output); worst && !status)
      worst = status;
  }
  console.answer()["recordings"] = std::move(rows);
  console.answer()["log"] = command.output.string();
  console.say(
      fmt::format("{} recordings; readings in {}", recordings->size(), command.output.string()));
  if (failed > 0)
    return Error{en::count("{} recordings could not be inspected",
                           "{} recording could not be inspected", failed),
                 command.output, en::say("the table has the reasons")};
  return worst;
}

/// Error: a reading is outside of its tolerance, or it is not certain that all are inside.
Status run_inspect(const InspectCommand& command, Console& console) {
  const auto recipe = InspectionRecipe::load(command.recipe);
  if (!recipe) return recipe.error();
  InspectionOrder order = command.order;
  order.recipe = *recipe;
  if (command.report)  // before the work
    if (const auto drawing = load_figures(); !drawing) return drawing.error();
  set_opencv_threads(1);  // each thread has frames of its own
  if (command.each) return run_each(command, order, console);
  const auto log = inspect_recording(order, console.job());
  if (!log) return log.error();
  for (const Message& remark : log->remarks) console.warn(fmt::format("Warning: {}", remark));
  const Status written = write_file_atomically(command.output, log->to_csv());
  if (!written) return written;
  print_log(*log, console);
  console.answer()["log"] = command.output.string();
  console.say(fmt::format("{} frames; readings in {}", log->rows.size(), command.output.string()));
  if (command.report)
    if (const Status reported = write_report(*log, order, *command.report, console); !reported)
      return reported;
  if (log->verdict() == Conformity::kPass)
    console.say("All readings are within their tolerances with 95 % certainty each.");
  return status_of(log->verdict(), command.output);
}

}  // namespace

void add_inspect(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<InspectCommand>();
  CLI::App* command = add_command(program, "inspect");
  command->add_option("FINGER", options->order.finger, "The finger's folder")->required();
  command->add_option("INPUT", options->order.inputs, "Images, folders of them, a video or a scene")
      ->required();
  command
      ->add_option("--recipe", options->recipe,
                   "Readings and their tolerances, as the page Inspect saves them")
      ->type_name("RECIPE.yaml")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Table to write: one line for each frame and reading")
      ->type_name("LOG.csv")
      ->required();
  auto* report =
      command->add_option("--report", options->report, "Report to sign to write, with plots")
          ->type_name("REPORT.pdf");
  command
      ->add_flag("--each", options->each,
                 "Each input is a recording of its own, a folder each video in it; one line for "
                 "each recording and reading")
      ->excludes(report);
  command
      ->add_option("--threads", options->order.threads,
                   "Threads (default: all cores); the results do not depend on it")
      ->type_name("N")
      ->transform(typed_integer(1, 64));
  command->callback(
      [=, &chosen] { chosen = [=](Console& console) { return run_inspect(*options, console); }; });
}

}  // namespace alltact
