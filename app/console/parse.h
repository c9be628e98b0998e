// Reads a command line.
#pragma once

#include "core/base/file_names.h"

#include <algorithm>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace alltact {

/// Parses a command line. Paths in it, also behind '=', become as they are stored. Throws
/// CLI::ParseError.
inline void parse(CLI::App& program, int argc, const char* const* argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  for (std::string& word : words) {
    const std::size_t mark = word.starts_with('-') ? word.find('=') : std::string::npos;
    const std::size_t begin = mark == std::string::npos ? 0 : mark + 1;
    word = word.substr(0, begin) + as_stored(word.substr(begin)).string();
  }
  std::reverse(words.begin(), words.end());  // as CLI11 expects
  program.parse(std::move(words));
}

}  // namespace alltact
