#include "tests/support/program.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace alltact::test {
namespace fs = std::filesystem;

namespace {

std::string quoted(const std::string& word) {
  std::string text(1, '\'');
  for (const char c : word) {
    if (c == '\'') text += "'\\'";  // closes, escapes one; c itself opens anew
    text.push_back(c);
  }
  text.push_back('\'');
  return text;
}

}  // namespace

ProgramRun run_shell(const std::string& command) {
  const TemporaryFolder folder;
  std::string redirected = "{ ";
  redirected.append(command).append("\n} </dev/null >").append(quoted((folder / "out").string()));
  redirected.append(" 2>").append(quoted((folder / "err").string()));
  const int status = std::system(redirected.c_str());
  ProgramRun run;
  run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.output = text_of(folder / "out");
  run.errors = text_of(folder / "err");
  return run;
}

ProgramRun run_shell_until(const std::string& command, const std::string& succeeds) {
  // A shell lets what runs beside it ignore Ctrl-C.
  return run_shell("env --default-signal=INT " + command + " & pid=$!\n" +
                   "for try in $(seq 600); do\n  { " + succeeds +
                   "; } 2>/dev/null && break\n  kill -0 $pid 2>/dev/null || break\n  sleep "
                   "0.1\ndone\nkill -INT $pid; wait $pid");
}

ProgramRun run_alltact(const std::vector<std::string>& arguments) {
  std::string command = quoted(ALLTACT_PROGRAM);
  for (const std::string& argument : arguments) command.append(1, ' ').append(quoted(argument));
  return run_shell(command);
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::vector<std::pair<std::string, std::string>> contents_of(const fs::path& folder) {
  std::vector<std::pair<std::string, std::string>> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      contents.emplace_back(fs::relative(entry.path(), folder).string(), text_of(entry.path()));
  }
  std::sort(contents.begin(), contents.end());
  return contents;
}

}  // namespace alltact::test
