// What the command line's own tables say of an option, for completions and manual pages.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace alltact {

/// What is completed where a value is asked for.
enum class ValueKind {
  kNone = 1,  ///< a number or a text: nothing can be offered
  kWords,     ///< OptionWords::words
  kFile,      ///< a file or a folder
  kFolder,
};

struct OptionWords {
  std::vector<std::string> names;  ///< "-o", "--output"; empty: told by its place alone
  std::string value;               ///< "DIR"; empty for a flag
  ValueKind kind = ValueKind::kNone;
  std::vector<std::string> words;  ///< all that can be given, of kWords
  bool is_list = false;            ///< several of the words, with commas
  bool is_required = false;
  bool is_repeated = false;  ///< may be given again, or have several values
  std::string group;         ///< the help's headline above it
  std::string what;          ///< the help's sentences
  std::string short_what;    ///< the first few words of these
};

/// Options of a command, or of a program that has none, in the help's order, without hidden ones.
[[nodiscard]] std::vector<OptionWords> options_of(const CLI::App& command);

}  // namespace alltact
