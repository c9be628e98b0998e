#include "app/commands/commands.h"
#include "calibration/finger_check.h"
#include "calibration/hard_cases/hard_cases.h"

#include <fmt/format.h>

namespace alltact {

Status run_check(const Path& folder, Console& console) {
  const auto finger = load_finger(folder, console);
  if (!finger) return finger.error();
  const FingerCheck check = check_finger(folder, *finger, console.job());
  Console::Json items = Console::Json::array();
  for (const CheckItem& item : check.items) {
    console.say(fmt::format("{:<12} {:<8} {}", item.what, to_string(item.state), item.sentence));
    items.push_back(
        {{"what", item.what}, {"state", to_string(item.state)}, {"sentence", item.sentence}});
  }
  console.answer()["finger"] = finger->name;
  console.answer()["fit"] = check.fit;
  console.answer()["items"] = std::move(items);
  if (!check.fit) return Error{"not fit to use; what is missing stands above", folder.string(), ""};
  console.say(fmt::format("{} is fit to use.", finger->name));
  return {};
}

Status run_check_numerics(Console& console) {
  Console::Json rows = Console::Json::array();
  int failed = 0;
  // JSON has no infinity: null says that the plain formula gave no number.
  const auto number = [](double error) {
    return std::isfinite(error) ? Console::Json(error) : Console::Json();
  };
  console.say(
      fmt::format("{:>9}  {:>9}  {:>9}  {:<5}  {}", "plain", "ours", "bound", "holds", "what"));
  for (const HardCase& one : hard_cases()) {
    failed += !one.holds();
    console.say(fmt::format("{:>9.2g}  {:>9.2g}  {:>9.2g}  {:<5}  {} ({}; plain: {})",
                            one.plain_error,
                            one.our_error,
                            one.bound,
                            one.holds() ? "yes" : "NO",
                            one.what,
                            one.unit,
                            one.plain));
    rows.push_back({{"what", one.what},
                    {"plain", one.plain},
                    {"unit", one.unit},
                    {"plain_error", number(one.plain_error)},
                    {"our_error", number(one.our_error)},
                    {"bound", one.bound},
                    {"holds", one.holds()}});
  }
  const std::size_t all = rows.size();
  console.answer()["numerics"] = std::move(rows);
  console.answer()["failed"] = failed;
  if (failed > 0)
    return Error{
        fmt::format(
            "{} of {} calculations are less exact on this computer than they must be", failed, all),
        "",
        "reporting the table above with the kind of processor"};
  console.say(
      fmt::format("All {} calculations are as exact on this computer as they must be.", all));
  return {};
}

void add_check(CLI::App& program, Chosen& chosen) {
  auto folder = std::make_shared<Path>();
  auto numerics = std::make_shared<bool>(false);
  CLI::App* command =
      program.add_subcommand("check", "Is this finger fit to use? What is missing, stale or weak");
  CLI::Option* finger = command->add_option("FINGER", *folder, "The finger's folder");
  command
      ->add_flag(
          "--numerics",
          *numerics,
          "Instead of a finger: is this computer as exact as it must be? What plain formulas "
          "make of hard cases, what ours make of them, and the bound")
      ->excludes(finger);
  command->callback([=, &chosen] {
    if (!*numerics && finger->count() == 0) throw CLI::RequiredError("FINGER");
    chosen = [=](Console& console) {
      return *numerics ? run_check_numerics(console) : run_check(*folder, console);
    };
  });
}

}  // namespace alltact
