// Descriptions of options from the command line's own tables, for completions and manual pages.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace alltact {

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

/// Options of a command, or of a program that has none, in the help's order, without hidden ones.
[[nodiscard]] std::vector<OptionInfo> options_of(const CLI::App& command);

}  // namespace alltact
