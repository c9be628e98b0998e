// What C++ sources say through en::say and its like, for tests of what is said to people.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace alltact::test {

/// A call of en::say, en::count or en::word.
struct SaidText {
  std::filesystem::path file;
  int line = 0;
  std::string words;  ///< adjacent literals joined and escapes read; empty: no literal stands there
  std::string comment;  ///< of what is counted, the template for one; of a word, what it is said of
};

[[nodiscard]] std::vector<SaidText> said_in(const std::filesystem::path& file);

/// In all .h and .cpp files below a folder, in the order of their names.
[[nodiscard]] std::vector<SaidText> said_below(const std::filesystem::path& folder);

}  // namespace alltact::test
