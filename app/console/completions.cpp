#include "app/console/completions.h"

#include <algorithm>

namespace alltact {

Result<std::string> completions(const CLI::App& program, std::string_view shell) {
  if (shell == "bash") return bash_completions(program);
  if (shell == "zsh") return zsh_completions(program);
  if (shell == "fish") return fish_completions(program);
  return Error{en::say("there are no completions for this shell"),
               std::string(shell),
               en::say("bash, zsh or fish")};
}

std::string single_quoted(std::string_view text) {
  std::string quoted(1, '\'');
  for (const char letter : text) {
    if (letter == '\'') quoted += "'\\'";  // closes, escapes one; the letter itself opens again
    quoted += letter;
  }
  return quoted + "'";
}

std::string function_name(const CLI::App& program) {
  std::string name = "_" + program.get_name();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace alltact
