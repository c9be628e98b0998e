#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/checks/check_history.h"
#include "calibration/checks/contact_free_check.h"
#include "calibration/checks/finger_check.h"
#include "calibration/checks/gage_readings.h"
#include "calibration/checks/gage_study.h"
#include "calibration/checks/press_check.h"
#include "calibration/finger/calibrate_finger.h"
#include "calibration/finger/calibration_report.h"
#include "core/base/program.h"
#include "core/base/utc_time.h"
#include "tests/hard_cases/hard_cases.h"

#include <fmt/format.h>

namespace alltact {

namespace {

Console::Json entry_json(const CheckEntry& entry) {
  return {{"time", entry.time},
          {"verdict", to_string(entry.verdict)},
          {"error_mm", entry.error_mm},
          {"drifting_above_mm", entry.drifting_above_mm},
          {"recalibrate_above_mm", entry.recalibrate_above_mm},
          {"light_percent", entry.light_percent},
          {"presses", entry.presses},
          {"ball_radius_mm", entry.ball_radius_mm},
          {"calibration_date", entry.calibration_date},
          {"program_version", entry.program_version},
          {"bias_mm", json_of(entry.bias_mm)},
          {"operator", entry.operator_name}};
}

/// The last checks with presses, oldest first.
Status print_history(const Path& folder, Console& console) {
  constexpr std::size_t kShown = 5;
  std::vector<Message> warnings;
  const auto checks = load_checks(folder, &warnings);
  if (!checks) return checks.error();
  for (const Message& warning : warnings) console.warn(fmt::format("Warning: {}", warning));
  Console::Json all = Console::Json::array();
  for (const CheckEntry& entry : *checks) all.push_back(entry_json(entry));
  console.answer()["checks"] = std::move(all);
  const std::size_t first = checks->size() > kShown ? checks->size() - kShown : 0;
  for (std::size_t i = first; i < checks->size(); ++i) {
    const CheckEntry& entry = (*checks)[i];
    console.say(fmt::format(
        "checked {}: {:<11} {:.3f} mm (passes up to {:.3f} mm), light {:+.1f} %", entry.time,
        to_string(entry.verdict), entry.error_mm, entry.drifting_above_mm, entry.light_percent));
  }
  return {};
}

void print_check(const PressCheck& check, Console& console) {
  console.say(fmt::format("{:<24} {:>9} {:>9} {:>9} {:>9}", "press", "depth mm", "error mm",
                          "factor", "light %"));
  Console::Json presses = Console::Json::array();
  for (const CheckedPress& press : check.presses) {
    console.say(fmt::format("{:<24} {:>9.3f} {:>9.4f} {:>9.3f} {:>9.1f}", press.name,
                            press.depth_mm, press.error_mm, press.factor,
                            100 * press.light_change));
    presses.push_back({{"press", press.name},
                       {"depth_mm", press.depth_mm},
                       {"error_mm", press.error_mm},
                       {"factor", press.factor},
                       {"light_percent", 100 * press.light_change}});
  }
  for (const Message& reason : check.left_out) console.warn(fmt::format("Left out: {}", reason));
  console.say(fmt::format("Verdict: {}.", check.sentence));
  Console::Json& answer = console.answer();
  answer["verdict"] = to_string(check.verdict);
  answer["sentence"] = check.sentence.english();
  answer["error_mm"] = check.error_mm;
  answer["drifting_above_mm"] = check.drifting_above_mm;
  answer["recalibrate_above_mm"] = check.recalibrate_above_mm;
  answer["factor"] = check.factor;
  answer["bias_mm"] = check.bias_mm;
  answer["light_percent"] = 100 * check.light_change;
  answer["ball_radius_mm"] = check.ball_radius_mm;
  answer["positions"] = check.positions;
  answer["presses"] = std::move(presses);
  answer["left_out"] = in_english(check.left_out);
}

/// Checks the calibration with new presses and stores the outcome. Error: calibrate again.
Status run_check_presses(const Path& folder, const PressInput& presses, const PressSet& press_set,
                         Console& console) {
  const auto snapshot = open_finger(folder, console);
  if (!snapshot) return snapshot.error();
  const Finger& finger = (*snapshot)->finger;
  const auto check = check_with_presses(**snapshot, presses, press_set, console.job());
  if (!check) return check.error();
  print_check(*check, console);
  console.answer()["finger"] = finger.name;
  const Status saved = append_check(
      folder, entry_of(*check, finger, utc_now(), program_version(), press_set.operator_name));
  if (!saved) return saved.error();
  if (check->verdict == CheckVerdict::kRecalibrate)
    return Error{en::say("the finger must be calibrated again; the reason is above"), folder,
                 en::say("alltact calibrate with new presses")};
  return {};
}

/// Compares images of the finger out of contact with its reference. Error: record that again.
Status run_check_reference(const Path& folder, const std::vector<Path>& images, Console& console) {
  const auto finger = open_finger(folder, console);
  if (!finger) return finger.error();
  const auto check = check_contact_free(**finger, images, console.job());
  if (!check) return check.error();
  for (const Message& reason : check->left_out) console.warn(fmt::format("Left out: {}", reason));
  console.say(fmt::format("Verdict: {}.", check->sentence));
  Console::Json& answer = console.answer();
  answer["finger"] = (*finger)->finger.name;
  answer["verdict"] = to_string(check->verdict);
  answer["sentence"] = check->sentence.english();
  answer["light_percent"] = 100 * check->light_change;
  answer["false_depth_mm"] = check->false_depth_mm;
  answer["uncorrected_mm"] = check->uncorrected_mm;
  answer["limit_mm"] = check->limit_mm;
  answer["pictures"] = check->image_count;
  answer["left_out"] = in_english(check->left_out);
  if (check->verdict == CheckVerdict::kRecalibrate)
    return Error{
        en::say("the reference must be recorded again; the reason is above"), folder.string(),
        en::say("alltact reference with a new recording, then alltact check with presses")};
  return {};
}

/// Prints the grade of a finger's calibration, and its last checks. Error: it is not fit to use.
Status run_check(const Path& folder, Console& console) {
  const auto finger = open_finger(folder, console);
  if (!finger) return finger.error();
  const FingerCheck check = check_finger(**finger, console.job(), utc_now());
  Console::Json items = Console::Json::array();
  for (const CheckItem& item : check.items) {
    console.say(fmt::format("{:<12} {:<8} {}", item.what, to_string(item.state), item.sentence));
    items.push_back({{"what", item.what},
                     {"state", to_string(item.state)},
                     {"sentence", item.sentence.english()}});
  }
  console.answer()["finger"] = (*finger)->finger.name;
  console.answer()["fit"] = check.fit;
  console.answer()["items"] = std::move(items);
  if (check.verdict) console.answer()["verdict"] = verdict_json(*check.verdict);
  if (const Status printed = print_history(folder, console); !printed) return printed;
  if (!check.fit)
    return Error{en::say("not fit to use; what is missing stands above"), folder.string(), ""};
  const bool is_proven = check.verdict && (check.verdict->grade == Grade::kGood ||
                                           check.verdict->grade == Grade::kUsable);
  const std::string name = (*finger)->finger.name;
  console.say(
      is_proven
          ? fmt::format("{} is fit to use.", name)
          : fmt::format(
                "{} can be used, but its calibration is unproven; see above for what is missing.",
                name));
  return {};
}

Console::Json anova_json(std::string_view source, const AnovaRow& row) {
  return {{"source", source}, {"ss", row.ss},        {"df", row.df},
          {"ms", row.ms},     {"f", json_of(row.f)}, {"p", json_of(row.p)}};
}

void print_anova(const GageStudy& study, Console& console) {
  const std::array<std::pair<std::string_view, const AnovaRow*>, 5> rows{
      {{"parts", &study.by_part},
       {"operators", &study.by_operator},
       {"parts x operators", &study.interaction},
       {"repeats", &study.repetition},
       {"total", &study.total}}};
  console.say(fmt::format("{:<24} {:>6} {:>12} {:>12} {:>10} {:>8}", "analysis of variance", "df",
                          "SS", "MS", "F", "p"));
  Console::Json all = Console::Json::array();
  for (const auto& [source, row] : rows) {
    all.push_back(anova_json(source, *row));
    if (row->df == 0) continue;
    console.say(fmt::format("  {:<22} {:>6} {:>12.5g} {:>12.5g} {:>10} {:>8}", source, row->df,
                            row->ss, row->ms, row->f ? fmt::format("{:.3f}", *row->f) : "",
                            row->p ? fmt::format("{:.4f}", *row->p) : ""));
  }
  console.answer()["anova"] = std::move(all);
  console.answer()["interaction_is_pooled"] = study.is_pooled;
}

void print_variation(const GageStudy& study, double tolerance_mm, Console& console) {
  const auto interval = [](const SdInterval& of) {
    return fmt::format("{:.4f} .. {:.4f}", of.low, of.high);
  };
  const std::array<std::tuple<std::string_view, double, std::string>, 7> rows{
      {{"gage R&R", study.gage, interval(study.gage_95)},
       {"  repeatability", study.repeatability, interval(study.repeatability_95)},
       {"  reproducibility", study.reproducibility, ""},
       {"    operators", study.operators_sd, ""},
       {"    parts x operators", study.interaction_sd, ""},
       {"parts", study.parts_sd, ""},
       {"total", study.total_sd, ""}}};
  console.say(fmt::format("{:<24} {:>9} {:>20} {:>13} {:>13}", "variation", "sd mm", "95 %",
                          "% of total", tolerance_mm > 0 ? "% of tolerance" : ""));
  for (const auto& [what, sd, range] : rows)
    console.say(fmt::format(
        "{:<24} {:>9.4f} {:>20} {:>13.1f} {:>13}", what, sd, range, study.percent(sd),
        tolerance_mm > 0 ? fmt::format("{:.1f}", GageStudy::percent_of(tolerance_mm, sd)) : ""));
}

Result<GageReadings> read_gage(const std::vector<Path>& inputs, const Job& job) {
  std::error_code failed;
  const bool is_table =
      inputs.size() == 1 && !std::filesystem::is_directory(inputs.front(), failed);
  return is_table ? read_gage_table(inputs.front()) : read_gage_checks(inputs, job);
}

/// Prints how much of the variation of measurements comes from the measuring itself.
Status run_check_gage(const std::vector<Path>& inputs, double tolerance_mm, Console& console) {
  const auto read = read_gage(inputs, console.job());
  if (!read) return read.error();
  for (const Message& remark : read->remarks) console.warn(remark.english());
  const auto study = gage_study(read->readings);
  if (!study) return study.error();
  console.say(fmt::format("{} parts, {} operators, {} repeats; mean {:.4f} mm", study->parts.size(),
                          study->operators.size(), study->repeats, read->origin_mm + study->mean));
  print_variation(*study, tolerance_mm, console);
  print_anova(*study, console);
  console.say(fmt::format("Distinct categories: {}.", study->categories));
  console.say(gage_sentence(*study, tolerance_mm).english());
  Console::Json& answer = console.answer();
  answer["parts"] = study->parts;
  answer["operators"] = study->operators;
  answer["repeats"] = study->repeats;
  answer["mean_mm"] = read->origin_mm + study->mean;
  answer["gage_sd_mm"] = study->gage;
  answer["gage_sd_95_mm"] = {study->gage_95.low, study->gage_95.high};
  answer["repeatability_sd_mm"] = study->repeatability;
  answer["repeatability_sd_95_mm"] = {study->repeatability_95.low, study->repeatability_95.high};
  answer["reproducibility_sd_mm"] = study->reproducibility;
  answer["operators_sd_mm"] = study->operators_sd;
  answer["interaction_sd_mm"] = study->interaction_sd;
  answer["parts_sd_mm"] = study->parts_sd;
  answer["total_sd_mm"] = study->total_sd;
  answer["gage_percent_of_total"] = study->percent(study->gage);
  if (tolerance_mm > 0)
    answer["gage_percent_of_tolerance"] = GageStudy::percent_of(tolerance_mm, study->gage);
  answer["distinct_categories"] = study->categories;
  answer["remarks"] = in_english(read->remarks);
  return {};
}

/// Prints the accuracy of hard calculations on this computer (hard_cases.h). Error: one is out of
/// bounds.
Status run_check_numerics(Console& console) {
  Console::Json rows = Console::Json::array();
  int failed = 0;
  // JSON has no infinity: null means a number that is not finite, or a false one.
  const auto number = [](double error) {
    return std::isfinite(error) ? Console::Json(error) : Console::Json();
  };
  console.say(fmt::format("{:>9}  {:>9}  {:>9}  {:>8}  {:<5}  {}", "naive", "ours", "bound",
                          "answered", "holds", "what"));
  for (const HardCase& one : hard_cases()) {
    failed += !one.holds();
    console.say(fmt::format("{:>9.2g}  {:>9.2g}  {:>9.2g}  {:>6.1f} %  {:<5}  {} ({}; naive: {})",
                            one.naive_score.error, one.own_score.error, one.bound,
                            100 * one.own_score.answered, one.holds() ? "yes" : "NO", one.what,
                            one.unit, one.naive));
    rows.push_back({{"what", one.what},
                    {"plain", one.naive},
                    {"unit", one.unit},
                    {"plain_error", number(one.naive_score.error)},
                    {"our_error", number(one.own_score.error)},
                    {"bound", one.bound},
                    {"answered", one.own_score.answered},
                    {"must_be_answered", one.min_answered},
                    {"holds", one.holds()}});
  }
  const std::size_t all = rows.size();
  console.answer()["numerics"] = std::move(rows);
  console.answer()["failed"] = failed;
  if (failed > 0)
    return Error{en::say("{} of {} calculations are less exact on this computer than they must be",
                         failed, all),
                 "", en::say("reporting the table above with the kind of processor")};
  console.say(
      fmt::format("All {} calculations are within their error bounds on this computer.", all));
  return {};
}

}  // namespace

void add_check(CLI::App& program, Chosen& chosen) {
  auto folder = std::make_shared<Path>();
  auto numerics = std::make_shared<bool>(false);
  auto presses = std::make_shared<PressInput>();
  auto press_set = std::make_shared<PressSet>();
  auto untouched = std::make_shared<std::vector<Path>>();
  auto gage = std::make_shared<std::vector<Path>>();
  auto tolerance_mm = std::make_shared<double>(0);
  CLI::App* command = add_command(program, "check");
  CLI::Option* finger = command->add_option("FINGER", *folder, "The finger's folder");
  CLI::Option* images =
      command
          ->add_option("--presses", presses->files,
                       "Checks the calibration with three or more new images of the pressed ball: "
                       "pass, drifting or recalibrate; stored in checks.csv")
          ->type_name("PICTURE...")
          ->needs(finger);
  command
      ->add_option("--ball-radius-mm", press_set->ball_radius_mm,
                   "Radius of the pressed ball, mm (default: that of the calibration)")
      ->type_name("R")
      ->transform(typed_number(kBallRadius))
      ->needs(images);
  command
      ->add_option("--operator", press_set->operator_name,
                   "Who pressed, stored with the check: for --gage")
      ->type_name("NAME")
      ->needs(images);
  PressFlags bodies;
  bodies.add_to(*command, "step");
  bodies.add_to(*command, "body");
  command
      ->add_option("--untouched", *untouched,
                   "Checks the reference with new images of the untouched finger: whether the "
                   "light has drifted and the reference must be recorded again")
      ->type_name("PICTURE...")
      ->needs(finger)
      ->excludes(images);
  CLI::Option* study =
      command
          ->add_option("--gage", *gage,
                       "Gage R&R by analysis of variance (AIAG): the checks of several fingers by "
                       "their operators, or a table with the columns part, operator, value_mm")
          ->type_name("FINGER...|TABLE")
          ->excludes(finger)
          ->excludes(images);
  command->add_option("--tolerance-mm", *tolerance_mm, "Width of the tolerance, mm, for --gage")
      ->type_name("T")
      ->transform(typed_number(1e-6, 1e6))
      ->needs(study);
  command
      ->add_flag("--numerics", *numerics,
                 "Checks the numerical accuracy of this computer instead of a finger: errors of "
                 "naive formulas and of ours in hard cases, and the bound")
      ->excludes(finger)
      ->excludes(study);
  command->callback([=, &chosen] {
    if (!*numerics && finger->count() == 0 && gage->empty()) throw CLI::RequiredError("FINGER");
    chosen = [=](Console& console) {
      if (!gage->empty()) return run_check_gage(*gage, *tolerance_mm, console);
      if (!untouched->empty()) return run_check_reference(*folder, *untouched, console);
      if (!presses->files.empty()) {
        bodies.say(*press_set);
        return run_check_presses(*folder, *presses, *press_set, console);
      }
      return *numerics ? run_check_numerics(console) : run_check(*folder, console);
    };
  });
}

}  // namespace alltact
