#include "app/commands/commands.h"
#include "app/commands/gauge_flags.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/force/collect_force.h"
#include "calibration/force/train_force.h"
#include "core/base/atomic_file.h"

#include <fmt/format.h>

namespace alltact {
namespace {

struct ForceOptions {
  Path finger;
  std::vector<Path> tables;
  std::optional<ForceSplit> split;
  std::optional<ForceKind> kind;
  bool is_kind_given = false;  ///< else, with `again`, as before; kind is empty for "auto"
  std::optional<double> creep_s;
  bool again = false;  ///< with the finger's stored table, split, kind and creep
  bool undo = false;   ///< back to the model from before
  int threads = 1;
  std::vector<Path> recording;  ///< a table is made of it, and of:
  Path gauge, output;           ///< gauge: empty where it lies next to the recording
  GaugeFileOptions gauge_file;
  CollectOptions collect;
};

constexpr std::array<const char*, 3> kAxisNames{"fx", "fy", "fz"};

std::string newtons(const Eigen::VectorXd& values) {
  std::string text;
  for (const double value : values) text += fmt::format(" {:>7.3f}", value);
  return text;
}

Console::Json json_of(const Eigen::VectorXd& values) {
  return Console::Json(std::vector<double>(values.begin(), values.end()));
}

void print_comparison(const TrainedForce& trained, Console& console) {
  const int axes = trained.model.axes;
  std::string head;
  for (int axis = 0; axis < axes; ++axis)
    head += fmt::format(" {:>7}", kAxisNames[static_cast<std::size_t>(axis)]);
  console.say("Mean absolute error on held-out rows, N");
  const std::size_t width = 8 * static_cast<std::size_t>(axes);
  console.say(
      fmt::format("{:<10}{:<{}}   {:<{}}   {}", "", head, width, head, width, "shuffled forces"));
  console.say(fmt::format("{:<10} {:<{}}   {:<{}}   {}", "", "full groups", width - 1,
                          "frames: biased", width - 1, "R2"));
  Console::Json rows = Console::Json::array();
  for (const ForceComparison& row : trained.comparison) {
    console.say(fmt::format("{:<10}{}   {}   {:>8.3f}{}", to_string(row.kind), newtons(row.mae_N),
                            newtons(row.random_mae_N), row.shuffled_r2.value_or(0),
                            row.kind == trained.model.kind ? "   selected" : ""));
    Console::Json entry{{"model", to_string(row.kind)},
                        {"mae_n", json_of(row.mae_N)},
                        {"rmse_n", json_of(row.rmse_N)},
                        {"r2", json_of(row.r2)},
                        {"random_mae_n", json_of(row.random_mae_N)}};
    if (row.shuffled_r2) entry["shuffled_r2"] = *row.shuffled_r2;
    rows.push_back(std::move(entry));
  }
  console.answer()["comparison"] = std::move(rows);
}

void print_training(const TrainedForce& trained, Console& console) {
  print_comparison(trained, console);
  const auto percent = [](const Eigen::VectorXd& part) {
    std::string text;
    for (const double one : part)
      text += fmt::format("{}{:.0f}", text.empty() ? "" : ", ", 100 * one);
    return text;
  };
  console.say(
      fmt::format("The 90 % intervals contain {} % of the held-out rows, the 95 % intervals {} %.",
                  percent(trained.covered_90), percent(trained.covered_95)));
  console.say(
      fmt::format("The noise of the gauge is at most{} N.", newtons(trained.label_noise_N)));
  for (const Message& remark : trained.remarks) console.say(remark.english());
  console.say(fmt::format("Selected model: {}.", to_string(trained.model.kind)));
  Console::Json& answer = console.answer();
  answer["kept"] = to_string(trained.model.kind);
  answer["rows"] = trained.held_out_N.rows();
  answer["covered_90"] = json_of(trained.covered_90);
  answer["covered_95"] = json_of(trained.covered_95);
  answer["label_noise_n"] = json_of(trained.label_noise_N);
  answer["remarks"] = in_english(trained.remarks);
}

/// The given gauge file, or the one that was written next to the recording.
Result<Path> gauge_file_of(const ForceOptions& options) {
  if (!options.gauge.empty()) return options.gauge;
  const Path log_file = gauge_log_of(options.recording.front());
  std::error_code ignored;
  if (options.recording.size() == 1 && std::filesystem::exists(log_file, ignored)) return log_file;
  return Error{en::say("there are no readings of a gauge beside the recording"), log_file,
               en::say("--gauge FILE, or alltact record --gauge")};
}

Console::Json json_of(const GaugeClock& clock) {
  static constexpr std::array<const char*, 3> kSources{"assumed", "given", "motion"};
  Console::Json json{{"source", kSources.at(static_cast<std::size_t>(clock.source) - 1)},
                     {"shift_s", clock.shift_s},
                     {"drift_ppm", 1e6 * clock.drift}};
  if (clock.source == GaugeClock::Source::kMotion) {
    json["sd_s"] = clock.sd_s;
    json["r2"] = clock.r2;
  }
  return json;
}

Status run_collect_force(const ForceOptions& options, Console& console) {
  const auto finger = open_finger(options.finger, console);
  if (!finger) return finger.error();
  const auto file = gauge_file_of(options);
  if (!file) return file.error();
  const auto gauge = ForceGauge::load(*file, options.gauge_file);
  if (!gauge) return gauge.error();
  Console::Json& answer = console.answer();
  if (!gauge->understood.empty()) {
    console.say(gauge->understood.english());
    answer["gauge_read_as"] = gauge->understood.english();
  }
  std::vector<Message> of_source;
  const auto frames = marker_frames(options.recording, **finger, console.job(), &of_source);
  if (!frames) return frames.error();
  auto collected = collect_force(*frames, *gauge, options.collect);
  if (!collected) return collected.error();
  collected->remarks.insert(collected->remarks.begin(), of_source.begin(), of_source.end());
  for (const Message& remark : collected->remarks) console.warn(remark.english());
  if (const Status saved = write_file_atomically(options.output, collected->table.to_csv()); !saved)
    return saved;
  console.say(fmt::format("{} rows in {}; {} of {} frames have no gauge reading.",
                          collected->table.rows(), options.output.string(), collected->left_out,
                          collected->frames));
  answer["rows"] = collected->table.rows();
  answer["left_out"] = collected->left_out;
  answer["clock"] = json_of(collected->clock);
  if (std::isfinite(collected->reading_sd_N)) {
    console.say(
        fmt::format("The gauge rounds its readings, sd {:.2g} N.", collected->reading_sd_N));
    answer["reading_sd_n"] = collected->reading_sd_N;
  }
  answer["remarks"] = in_english(collected->remarks);
  answer["table"] = options.output.string();
  return {};
}

/// The settings of the earlier training where it is repeated, overridden by the given ones.
Result<ForceTraining> training_of(const ForceOptions& options) {
  ForceTraining training;
  if (options.again) {
    const auto before = stored_force_training(options.finger);
    if (!before) return before.error();
    training = *before;
  }
  if (options.split) training.split = *options.split;
  if (options.is_kind_given) training.kind = options.kind;
  if (options.creep_s) training.creep_s = *options.creep_s;
  return training;
}

Status run_undo_force(const Path& folder, Console& console) {
  const auto finger = revert_force(folder);
  if (!finger) return finger.error();
  const std::string& model = (*finger)->finger.force_model;
  console.say(model.empty() ? std::string("The finger has no force model now.")
                            : fmt::format("The finger's force model is {} now.", model));
  console.answer()["model"] = model;
  return {};
}

/// Trains a finger's force model, or collects a table for that.
Status run_force(const ForceOptions& options, Console& console) {
  if (options.undo) return run_undo_force(options.finger, console);
  if (!options.recording.empty()) return run_collect_force(options, console);
  const auto finger = open_finger(options.finger, console);
  if (!finger) return finger.error();
  const auto training = training_of(options);
  if (!training) return training.error();
  const auto table =
      options.again ? stored_force_table(options.finger) : ForceTable::load_all(options.tables);
  if (!table) return table.error();
  for (const Message& understood : table->understood) console.say(understood.english());
  for (const Message& remark : table->remarks) console.warn(remark.english());
  console.answer()["read_as"] = in_english(table->understood);
  if (!table->ignored_columns.empty()) {
    std::string names;
    for (const std::string& name : table->ignored_columns)
      names += (names.empty() ? "" : ", ") + name;
    console.warn(fmt::format("Ignored columns: {}", names));
  }
  set_opencv_threads(options.threads);
  const auto trained = train_finger_force(options.finger, *table, *training, console.job());
  if (!trained) return trained.error();
  print_training(*trained, console);
  return {};
}

}  // namespace

void add_force(CLI::App& program, Chosen& chosen) {
  auto options = std::make_shared<ForceOptions>();
  CLI::App* command = add_command(program, "force");
  command->add_option("FINGER", options->finger, "The finger's folder")->required();
  CLI::Option* table = command->add_option(
      "TABLE", options->tables,
      "Table (CSV in any form that spreadsheets write), or several of the same finger, with "
      "columns "
      "u0, v0, u1, ... (px), fx_n and fy_n; optional: fz_n, seen0, ..., along_mm, across_mm, t_s, "
      "block, day, indenter");
  auto split = std::make_shared<std::string>(), kind = std::make_shared<std::string>();
  command
      ->add_option(
          "--split", *split,
          "Groups of rows that are held out together: block, day, indenter; random holds out "
          "single frames and underestimates the error (default block; with --again as before)")
      ->check(CLI::IsMember({"block", "day", "indenter", "random"}));
  command
      ->add_option("--model", *kind,
                   "Model to store: auto (the simplest that no other beats), mean, ridge, "
                   "quadratic, network (default auto; with --again as before)")
      ->check(CLI::IsMember({"auto", "mean", "ridge", "quadratic", "network"}));
  command
      ->add_option("--creep-s", options->creep_s,
                   "Creep as an input: displacements minus their running mean over this time in s, "
                   "0: none (default none; with --again as before)")
      ->transform(typed_number(0.0, 1e5));
  CLI::Option* again =
      command->add_flag("--again", options->again, "Trains again with the stored table");
  CLI::Option* undo = command->add_flag(
      "--undo", options->undo, "Restores the previous force model; given again, reverts this");
  CLI::Option* collect = command
                             ->add_option("--collect", options->recording,
                                          "Makes a table instead, from a recording, images, or "
                                          "results.jsonl of alltact reconstruct")
                             ->type_name("RECORDING");
  CLI::Option* gauge = command->add_option(
      "--gauge", options->gauge,
      "With --collect: gauge table with t_s or frame, fx_n, fy_n (or force_n alone), or truth.json "
      "of alltact simulate (default: RECORDING's NAME.gauge.csv). Commas, semicolons or tabs, "
      "decimal points or commas, units in the names as 'Zeit [ms]' or 'Load (lbf)', time stamps");
  gauge->type_name("FILE");
  CLI::Option* output =
      command->add_option("-o,--output", options->output, "With --collect: table file to write");
  output->type_name("TABLE");
  collect->needs(output);
  add_gauge_file_flags(*command, collect, options->gauge_file, options->collect);
  gauge->needs(collect), output->needs(collect);
  table->excludes(again)->excludes(undo)->excludes(collect);
  again->excludes(undo)->excludes(collect);
  undo->excludes(collect);
  add_threads_flag(*command, options->threads);
  command->callback([=, &chosen] {
    if (options->tables.empty() && !options->again && !options->undo && options->recording.empty())
      throw CLI::ValidationError("TABLE", "is required, or --again, --undo or --collect");
    const auto index_of = [](const auto& words, const std::string& word) {
      return std::find(words.begin(), words.end(), word) - words.begin() + 1;
    };
    if (!split->empty()) options->split = static_cast<ForceSplit>(index_of(kForceSplits, *split));
    options->is_kind_given = !kind->empty();
    if (options->is_kind_given && *kind != "auto")
      options->kind = static_cast<ForceKind>(index_of(kForceKinds, *kind));
    chosen = [=](Console& console) { return run_force(*options, console); };
  });
}

}  // namespace alltact
