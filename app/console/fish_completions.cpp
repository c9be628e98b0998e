#include "app/console/completions.h"
#include "app/console/option_info.h"

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr const char* kListFunction = R"(
function __alltact_list
  set -l typed (string replace -r '^--[a-z-]*=' '' -- (commandline -ct))
  set -l before (string match -r '^.*,' -- $typed)
  printf '%s\n' "$before"$argv
end
)";

/// The values of an option, or of a positional argument.
std::string values_of(const OptionInfo& option) {
  switch (option.kind) {
    case ValueKind::kWords:
      return option.is_list
                 ? fmt::format(" -f -a '(__alltact_list {})'", fmt::join(option.words, " "))
                 : fmt::format(" -f -a '{}'", fmt::join(option.words, " "));
    case ValueKind::kFile:
      return " -F";
    case ValueKind::kFolder:
      return " -f -a '(__fish_complete_directories)'";
    case ValueKind::kNone:
      break;
  }
  return " -f";
}

std::string lines_of(const CLI::App& command, const std::string& begin) {
  std::string lines;
  for (const OptionInfo& option : options_of(command)) {
    std::string names;
    for (const std::string& name : option.names)
      names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    std::string line = begin + names;
    if (option.names.empty() || !option.value.empty())
      line += (option.names.empty() ? "" : " -r") + values_of(option);
    if (!names.empty()) line += " -d " + single_quoted(option.short_what);
    lines += line + "\n";
  }
  return lines;
}

}  // namespace

std::string fish_completions(const CLI::App& program) {
  const std::string& name = program.get_name();
  std::string text = fmt::format("# Completions of {0} for fish.\ncomplete -c {0} -f\n", name);
  const auto commands = program.get_subcommands({});
  if (commands.empty()) return text + lines_of(program, "complete -c " + name);
  text += kListFunction;
  text += lines_of(program, fmt::format("complete -c {} -n __fish_use_subcommand", name));
  for (const CLI::App* command : commands)
    text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d {}\n",
                        name,
                        command->get_name(),
                        single_quoted(command->get_description()));
  for (const CLI::App* command : commands)
    text += lines_of(
        *command,
        fmt::format(
            "complete -c {} -n '__fish_seen_subcommand_from {}'", name, command->get_name()));
  return text;
}

}  // namespace alltact
