// The texts in C++ sources, for tests of what is said to people.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace alltact::test {

/// A string literal, adjacent ones joined and escapes read.
struct SourceText {
  std::filesystem::path file;
  int line = 0;
  std::string text;
  /// It is what an Error says, or is handed to fmt::format, a report of progress or a remark.
  bool is_told = false;
  /// It is handed to tr() or its like, or to Qt as it is.
  bool is_qt = false;
};

[[nodiscard]] std::vector<SourceText> texts_of(const std::filesystem::path& file);

/// Of all .h and .cpp files below a folder, in the order of their names.
[[nodiscard]] std::vector<SourceText> texts_below(const std::filesystem::path& folder);

/// The sentences of a text for fmt by what is written in them alone: holes are \x01, and nothing is
/// left of what only joins it to what stands before and after. "press{}" gives both its forms.
[[nodiscard]] std::set<std::string> bare_sentences(const std::string& text);

/// The same of a pattern with Qt's %1.
[[nodiscard]] std::string bare_pattern(const std::string& pattern);

/// Two words at least, or one that a person is told.
[[nodiscard]] bool is_for_people(const std::string& bare, bool is_told);

}  // namespace alltact::test
