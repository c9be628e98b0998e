#include "app/console/man_page.h"

#include "app/console/option_info.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace alltact {
namespace {

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
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
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
                        escaped(command->get_name()),
                        escaped(command->get_description()),
                        escaped(program.get_name()),
                        escaped(command->get_name()));
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

}  // namespace

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
                                 escaped(upper(page)),
                                 escaped(version));
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
