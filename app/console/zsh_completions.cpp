#include "app/console/completions.h"
#include "app/console/option_info.h"

#include <string_view>

#include <fmt/format.h>

namespace alltact {
namespace {

std::string escaped(std::string_view text, std::string_view letters) {
  std::string result;
  for (const char letter : text) {
    if (letters.find(letter) != std::string_view::npos) result += '\\';
    result += letter;
  }
  return result;
}

/// The action of `_arguments` for this value.
std::string action(const OptionInfo& option) {
  switch (option.kind) {
    case ValueKind::kWords:
      return option.is_list ? fmt::format("_sequence compadd - {}", fmt::join(option.words, " "))
                            : fmt::format("({})", fmt::join(option.words, " "));
    case ValueKind::kFile:
      return "_files";
    case ValueKind::kFolder:
      return "_files -/";
    case ValueKind::kNone:
      break;
  }
  return " ";
}

std::string spec_of_flag(const OptionInfo& option) {
  // Of several names one is enough, unless it may be given again.
  const bool once = !option.is_repeated;
  const std::string others =
      once && option.names.size() > 1 ? fmt::format("({})", fmt::join(option.names, " ")) : "";
  const std::string what = fmt::format("[{}]", escaped(option.short_what, "[]\\"));
  const std::string value =
      option.value.empty() ? ""
                           : fmt::format(":{}:{}", escaped(option.value, ":\\"), action(option));
  std::string specs;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    const std::string form = value.empty() ? name : name + (is_long ? "=" : "+");
    specs += "        " + single_quoted(others + (once ? "" : "*") + form + what + value) + " \\\n";
  }
  return specs;
}

std::string arguments_of(const CLI::App& command) {
  std::string specs;
  int position = 0;
  for (const OptionInfo& option : options_of(command)) {
    if (!option.names.empty()) {
      specs += spec_of_flag(option);
      continue;
    }
    ++position;
    const std::string where =
        option.is_repeated ? "*" : fmt::format("{}{}", position, option.is_required ? "" : ":");
    specs += "        " +
             single_quoted(
                 fmt::format("{}:{}:{}", where, escaped(option.value, ":\\"), action(option))) +
             " \\\n";
  }
  return "      _arguments -s -S \\\n" + specs.substr(0, specs.size() - 3) + "\n";
}

}  // namespace

std::string zsh_completions(const CLI::App& program) {
  const std::string& name = program.get_name();
  const std::string function = function_name(program);
  const std::string head = fmt::format("#compdef {}\n# Completions of {} for zsh.\n", name, name);
  const auto commands = program.get_subcommands({});
  if (commands.empty())
    return fmt::format(
        "{}{}() {{\n{}}}\n{} \"$@\"\n", head, function, arguments_of(program), function);
  std::string list, branches, own;
  for (const CLI::App* command : commands) {
    list += "    " +
            single_quoted(command->get_name() + ":" + escaped(command->get_description(), ":\\")) +
            "\n";
    branches += fmt::format("    {})\n{}      ;;\n", command->get_name(), arguments_of(*command));
  }
  for (const OptionInfo& option : options_of(program)) own += spec_of_flag(option);
  return fmt::format(
      "{0}{1}() {{\n"
      "  local state line\n"
      "  typeset -A opt_args\n"
      "  local -a commands=(\n{2}  )\n"
      "  _arguments -C \\\n{3}        '1:command:->command' '*::argument:->argument'\n"
      "  if [[ $state == command ]]; then\n    _describe -t commands command commands\n"
      "  elif [[ $state == argument ]]; then\n    case $line[1] in\n{4}    esac\n  fi\n}}\n{1} "
      "\"$@\"\n",
      head,
      function,
      list,
      own,
      branches);
}

}  // namespace alltact
