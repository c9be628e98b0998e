#include "app/commands/commands.h"
#include "app/console/command_names.h"
#include "app/console/flags.h"
#include "calibration/checks/check_history.h"
#include "calibration/checks/contact_free_check.h"
#include "calibration/checks/finger_check.h"
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
          {"program_version", entry.program_version}};
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
  const Status saved = append_check(folder, entry_of(*check, finger, utc_now(), program_version()));
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
  command
      ->add_flag("--numerics", *numerics,
                 "Checks the numerical accuracy of this computer instead of a finger: errors of "
                 "naive formulas and of ours in hard cases, and the bound")
      ->excludes(finger);
  command->callback([=, &chosen] {
    if (!*numerics && finger->count() == 0) throw CLI::RequiredError("FINGER");
    chosen = [=](Console& console) {
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
