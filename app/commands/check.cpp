#include "app/commands/commands.h"
#include "calibration/finger_check.h"

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

void add_check(CLI::App& program, Chosen& chosen) {
  auto folder = std::make_shared<Path>();
  CLI::App* command =
      program.add_subcommand("check", "Is this finger fit to use? What is missing, stale or weak");
  command->add_option("FINGER", *folder, "The finger's folder")->required();
  command->callback(
      [=, &chosen] { chosen = [=](Console& console) { return run_check(*folder, console); }; });
}

}  // namespace alltact
