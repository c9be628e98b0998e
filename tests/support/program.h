// Running `alltact` as a person would, and looking at what it leaves behind.
#pragma once

#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact::test {

struct ProgramRun {
  int status = -1;  ///< exit status; 128 + signal when it was killed
  std::string output;
  std::string errors;
};

/// Runs alltact with these arguments; nothing on standard input.
ProgramRun run_alltact(const std::vector<std::string>& arguments);

/// Runs a shell command, for what only the system can do (mount, ldd).
ProgramRun run_shell(const std::string& command);

/// Runs a shell command until another one succeeds, then stops it as Ctrl-C does, and waits for it;
/// at the latest after a minute, however slow the computer is.
ProgramRun run_shell_until(const std::string& command, const std::string& succeeds);

/// "" where the file cannot be read.
std::string text_of(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

/// Every file below a folder with its bytes, by relative path: two of these are equal when nothing
/// was changed, added or left over.
std::vector<std::pair<std::string, std::string>> contents_of(const std::filesystem::path& folder);

}  // namespace alltact::test
