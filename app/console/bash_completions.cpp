#include "app/console/completions.h"
#include "app/console/option_info.h"

#include <fmt/format.h>

namespace alltact {
namespace {

/// Appended to a command's table: offers the words that match the typed text.
constexpr const char* kOffer = R"(
  case $kind in
    words)
      local before_comma=
      if [[ $list && $word == *,* ]]; then before_comma=${word%,*},; fi
      if [[ $list ]]; then compopt -o nospace 2>/dev/null; fi
      mapfile -t COMPREPLY < <(compgen -P "$before_comma" -W "$words" -- "${word##*,}") ;;
    file) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$word") ;;
    folder) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$word") ;;
  esac
)";

/// `kind=words words='a b'` for the shell.
std::string assignments(const OptionInfo& option) {
  switch (option.kind) {
    case ValueKind::kWords:
      return fmt::format("kind=words words={}{}",
                         single_quoted(fmt::format("{}", fmt::join(option.words, " "))),
                         option.is_list ? " list=1" : "");
    case ValueKind::kFile:
      return "kind=file";
    case ValueKind::kFolder:
      return "kind=folder";
    case ValueKind::kNone:
      break;
  }
  return "kind=none";
}

/// One command's branches: by the flag before the word, by a dash, by position.
std::string table_of(const CLI::App& command, int first_position) {
  std::string flags, values, positions;
  std::vector<OptionInfo> positional;
  for (const OptionInfo& option : options_of(command)) {
    if (option.names.empty()) {
      positional.push_back(option);
      continue;
    }
    for (const std::string& name : option.names) flags += (flags.empty() ? "" : " ") + name;
    if (!option.value.empty())
      values +=
          fmt::format("        {}) {} ;;\n", fmt::join(option.names, "|"), assignments(option));
  }
  // Words after the last position belong to it: images, presses, frames.
  for (std::size_t i = 0; i < positional.size(); ++i) {
    const bool is_last = i + 1 == positional.size();
    positions +=
        fmt::format("          {}) {} ;;\n",
                    is_last ? "*" : fmt::format("{}", first_position + static_cast<int>(i)),
                    assignments(positional[i]));
  }
  if (!positions.empty())
    positions = fmt::format("        case $COMP_CWORD in\n{}        esac ;;\n", positions);
  return fmt::format(
      "      case $before in\n{}        *) if [[ $word == -* ]]; then kind=words words={}; "
      "else\n{}        fi ;;\n      esac ;;\n",
      values,
      single_quoted(flags),
      positions.empty() ? "          :\n" : positions.substr(0, positions.size() - 4) + "\n");
}

std::string names_of(const std::vector<const CLI::App*>& commands) {
  std::string names;
  for (const CLI::App* command : commands)
    names += (names.empty() ? "" : " ") + command->get_name();
  return names;
}

}  // namespace

std::string bash_completions(const CLI::App& program) {
  const std::string& name = program.get_name();
  const std::string function = function_name(program);
  const auto commands = program.get_subcommands({});
  std::string tables;
  for (const CLI::App* command : commands)
    tables += fmt::format("    {})\n{}", command->get_name(), table_of(*command, 2));
  const std::string own = commands.empty() ? table_of(program, 1) : std::string();
  std::string flags;
  for (const OptionInfo& option : options_of(program))
    for (const std::string& flag : option.names) flags += " " + flag;
  const std::string chosen =
      commands.empty()
          ? fmt::format("  case 1 in\n    1)\n{}  esac", own)
          : fmt::format(
                "  if ((COMP_CWORD == 1)); then\n    kind=words words={}\n  else\n  case "
                "${{COMP_WORDS[1]}} in\n{}  esac\n  fi",
                single_quoted(names_of(commands) + flags),
                tables);
  return fmt::format(
      "# Completions of {0} for bash.\n"
      "{1}() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}\n"
      "  local kind=none words= list=\n"
      "  COMPREPLY=()\n"
      "  # --flag=value comes in three words.\n"
      "  if [[ $word == = ]]; then word=; elif [[ $before == = ]]; then "
      "before=${{COMP_WORDS[COMP_CWORD - 2]}}; fi\n"
      "{2}\n{3}}}\ncomplete -F {1} {0}\n",
      name,
      function,
      chosen,
      kOffer);
}

}  // namespace alltact
