#include "app/console/completions_and_man_pages.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace alltact {
namespace {

/// The completion of a value.
enum class ValueKind {
  kNone = 1,  ///< a number or a text: nothing can be offered
  kWords,     ///< OptionInfo::words
  kFile,      ///< a file or a folder
  kFolder,
};

struct OptionInfo {
  std::vector<std::string> names;  ///< "-o", "--output"; empty: a positional argument
  std::string value;               ///< "DIR"; empty for a flag
  ValueKind kind = ValueKind::kNone;
  std::vector<std::string> words;  ///< all possible values, of kWords
  bool is_list = false;            ///< several of the words, with commas
  bool is_required = false;
  bool is_repeated = false;  ///< may be given again, or have several values
  std::string group;         ///< the help's headline above it
  std::string what;          ///< the help's sentences
  std::string short_what;    ///< the first few words of these
};

std::vector<std::string> split(std::string_view text, char divider) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(divider);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_' || c == '-';
  });
}

/// "a|b" or the set {a,b} of a check; empty where it is neither.
std::vector<std::string> words_in(const std::string& value, const std::string& checks) {
  auto words = split(value, '|');
  if (words.size() == 1) {
    const std::size_t open = checks.find('{'), close = checks.find('}');
    if (open == std::string::npos || close == std::string::npos) return {};
    words = split(std::string_view(checks).substr(open + 1, close - open - 1), ',');
  }
  return std::all_of(words.begin(), words.end(), is_word) ? words : std::vector<std::string>();
}

template <std::size_t kCount>
bool is_one_of(std::string_view value, const std::array<std::string_view, kCount>& names) {
  return std::find(names.begin(), names.end(), value) != names.end();
}

ValueKind kind_of(std::string_view value) {
  static constexpr std::array<std::string_view, 3> kFolders{"FINGER", "DIR", "FOLDER"};
  static constexpr std::array<std::string_view, 13> kFiles{
      "FILE",      "GAUGE.csv", "GRIPPER", "IMAGE",  "INPUT", "PICTURE",  "PRESS",
      "RECORDING", "RESULTS",   "SCENE",   "SOURCE", "TABLE", "TEXT|FILE"};
  if (value.ends_with("...")) value.remove_suffix(3);
  if (is_one_of(value, kFolders)) return ValueKind::kFolder;
  const std::size_t dot = value.find('.');  // FILE.html
  const bool names_a_file = dot != std::string_view::npos && is_word(value.substr(dot + 1));
  return names_a_file || is_one_of(value, kFiles) ? ValueKind::kFile : ValueKind::kNone;
}

/// Up to where the details begin, at most `kMaxLetters` letters and no partial words.
std::string shortened(const std::string& what) {
  constexpr std::size_t kMaxLetters = 72;
  std::size_t end = what.size();
  for (const std::string_view divider : {" (", ": ", "; ", ". "})
    end = std::min(end, what.find(divider));
  if (end > kMaxLetters) end = std::min(what.rfind(' ', kMaxLetters), what.rfind(',', kMaxLetters));
  return what.substr(0, std::min(end, what.size()));
}

OptionInfo words_of(const CLI::Option& option) {
  OptionInfo words;
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  const bool is_flag = option.get_items_expected_max() == 0;
  // The kind of value, and behind a colon the description of its checks.
  const std::string type = is_flag ? std::string() : option.get_type_name();
  const std::size_t colon = type.find(':');
  words.value = words.names.empty() ? option.get_name(true) : type.substr(0, colon);
  if (!is_flag)
    words.words = words_in(words.value, colon == std::string::npos ? "" : type.substr(colon));
  words.kind = words.words.empty() ? kind_of(words.value) : ValueKind::kWords;
  words.is_list = option.get_delimiter() != '\0';
  words.is_required = option.get_required();
  words.is_repeated = option.get_items_expected_max() > 1;
  words.group = option.get_group();
  words.what = option.get_description();
  words.short_what = shortened(words.what);
  return words;
}

/// Options of a command, or of a program that has none, in the help's order, without hidden ones.
std::vector<OptionInfo> options_of(const CLI::App& command) {
  std::vector<OptionInfo> all;
  for (const CLI::Option* option : command.get_options({}))
    if (!option->get_group().empty()) all.push_back(words_of(*option));
  return all;
}

/// A text for a shell, as one word between single quotes.
std::string single_quoted(std::string_view text) {
  std::string quoted(1, '\'');
  for (const char letter : text) {
    if (letter == '\'') quoted += "'\\'";  // closes, escapes one; the letter itself opens again
    quoted += letter;
  }
  return quoted + "'";
}

/// "_alltact_studio" for alltact-studio, as functions are named.
std::string function_name(const CLI::App& program) {
  std::string name = "_" + program.get_name();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Literal text: no letter has a meaning for roff.
std::string escaped(std::string_view text) {
  std::string result;
  if (text.starts_with('.') || text.starts_with('\'')) result = "\\&";
  for (const char letter : text) {
    if (letter == '\n') {
      result += "\n.br\n";
    } else if (letter == '\\') {
      result += "\\e";
    } else if (letter == '-' || letter == '`' || letter == '^' || letter == '~') {
      result += std::string("\\") + (letter == '-'   ? "-"
                                     : letter == '`' ? "(ga"
                                     : letter == '^' ? "(ha"
                                                     : "(ti");
    } else if (letter == '\'') {
      result += "\\(aq";
    } else {
      result += letter;
    }
  }
  return result;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string lower_first(std::string text) {
  if (text.size() > 1 && std::islower(static_cast<unsigned char>(text[1])) != 0)
    text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

/// ".TP", the option in bold with its value slanted, and what it does.
std::string paragraph_of(const OptionInfo& option) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + fmt::format("\\fB{}\\fR", escaped(name));
  if (!option.value.empty())
    names += fmt::format("{}\\fI{}\\fR", names.empty() ? "" : " ", escaped(option.value));
  return fmt::format(".TP\n{}\n{}\n", names, escaped(option.what));
}

std::string argument_name(const OptionInfo& option) {
  const std::string name =
      fmt::format("\\fI{}\\fR{}", escaped(option.value), option.is_repeated ? "..." : "");
  return option.is_required ? name : "[" + name + "]";
}

std::string synopsis_of(const std::string& called, const std::vector<OptionInfo>& options) {
  std::string text = fmt::format("\\fB{}\\fR [\\fIoptions\\fR]", escaped(called));
  for (const OptionInfo& option : options)
    if (option.names.empty()) text += " " + argument_name(option);
  return text + "\n";
}

/// Positional arguments first, then the groups of the help under one headline each.
std::string sections_of(const std::vector<OptionInfo>& options) {
  std::string positional, text;
  std::vector<std::string> order;
  std::map<std::string, std::string> groups;
  for (const OptionInfo& option : options) {
    if (option.names.empty()) {
      positional += paragraph_of(option);
      continue;
    }
    if (!groups.contains(option.group)) order.push_back(option.group);
    groups[option.group] += paragraph_of(option);
  }
  if (!positional.empty()) text += ".SH ARGUMENTS\n" + positional;
  for (const std::string& group : order) text += ".SH " + upper(group) + "\n" + groups[group];
  return text;
}

std::string commands_of(const CLI::App& program) {
  const auto commands = program.get_subcommands({});
  if (commands.empty()) return {};
  std::string text = ".SH COMMANDS\n";
  for (const CLI::App* command : commands)
    text += fmt::format(".TP\n\\fB{}\\fR\n{}; see \\fB{}\\-{}\\fR(1).\n",
                        escaped(command->get_name()), escaped(command->get_description()),
                        escaped(program.get_name()), escaped(command->get_name()));
  return text;
}

/// "Exit status: 0 done, ..." becomes a section of its own.
std::string footer_of(const CLI::App& program) {
  const std::string footer = program.get_footer();
  constexpr std::string_view kHead = "Exit status: ";
  const std::size_t begin = footer.find(kHead);
  if (begin == std::string::npos) return {};
  const std::size_t end = footer.find('\n', begin);
  return ".SH EXIT STATUS\n" +
         escaped(footer.substr(begin + kHead.size(),
                               end == std::string::npos ? end : end - begin - kHead.size())) +
         "\n";
}

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
      values, single_quoted(flags),
      positions.empty() ? "          :\n" : positions.substr(0, positions.size() - 4) + "\n");
}

std::string names_of(const std::vector<const CLI::App*>& commands) {
  std::string names;
  for (const CLI::App* command : commands)
    names += (names.empty() ? "" : " ") + command->get_name();
  return names;
}

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
                single_quoted(names_of(commands) + flags), tables);
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
      name, function, chosen, kOffer);
}

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

std::string zsh_completions(const CLI::App& program) {
  const std::string& name = program.get_name();
  const std::string function = function_name(program);
  const std::string head = fmt::format("#compdef {}\n# Completions of {} for zsh.\n", name, name);
  const auto commands = program.get_subcommands({});
  if (commands.empty())
    return fmt::format("{}{}() {{\n{}}}\n{} \"$@\"\n", head, function, arguments_of(program),
                       function);
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
      head, function, list, own, branches);
}

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

std::string fish_completions(const CLI::App& program) {
  const std::string& name = program.get_name();
  std::string text = fmt::format("# Completions of {0} for fish.\ncomplete -c {0} -f\n", name);
  const auto commands = program.get_subcommands({});
  if (commands.empty()) return text + lines_of(program, "complete -c " + name);
  text += kListFunction;
  text += lines_of(program, fmt::format("complete -c {} -n __fish_use_subcommand", name));
  for (const CLI::App* command : commands)
    text += fmt::format("complete -c {} -n __fish_use_subcommand -a {} -d {}\n", name,
                        command->get_name(), single_quoted(command->get_description()));
  for (const CLI::App* command : commands)
    text += lines_of(*command, fmt::format("complete -c {} -n '__fish_seen_subcommand_from {}'",
                                           name, command->get_name()));
  return text;
}

}  // namespace

Result<std::string> completions(const CLI::App& program, std::string_view shell) {
  if (shell == "bash") return bash_completions(program);
  if (shell == "zsh") return zsh_completions(program);
  if (shell == "fish") return fish_completions(program);
  return Error{en::say("there are no completions for this shell"), std::string(shell),
               en::say("bash, zsh or fish")};
}

std::string man_page(const CLI::App& program, const std::string& version, const CLI::App* command) {
  const std::string& name = program.get_name();
  const CLI::App& subject = command != nullptr ? *command : program;
  const std::string page = command != nullptr ? name + "-" + command->get_name() : name;
  const std::string called = command != nullptr ? name + " " + command->get_name() : name;
  const bool has_commands = command == nullptr && !program.get_subcommands({}).empty();
  const auto options = options_of(subject);
  std::string what = subject.get_description();
  if (const std::size_t colon = what.find(": "); command == nullptr && colon != std::string::npos)
    what = what.substr(colon + 2);
  while (what.ends_with('.')) what.pop_back();
  std::string text = fmt::format(".TH {} 1 \"\" \"AllTact {}\" \"User Commands\"\n.nh\n.ad l\n",
                                 escaped(upper(page)), escaped(version));
  text +=
      fmt::format(".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n", escaped(page), escaped(lower_first(what)));
  text += has_commands
              ? fmt::format("\\fB{}\\fR \\fICOMMAND\\fR [\\fIoptions\\fR]\n", escaped(name))
              : synopsis_of(called, options);
  text += ".SH DESCRIPTION\n" + escaped(subject.get_description()) + "\n";
  text += commands_of(subject) + sections_of(options) + footer_of(program);
  const std::string other = name == "alltact" ? "alltact-studio" : "alltact";
  text += fmt::format(".SH SEE ALSO\n{}\\fB{}\\fR(1)\n",
                      command != nullptr ? fmt::format("\\fB{}\\fR(1), ", escaped(name)) : "",
                      escaped(other));
  return text;
}

}  // namespace alltact
