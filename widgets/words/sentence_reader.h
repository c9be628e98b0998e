// Recognises the patterns that a text was made of.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace alltact {

/// A text as its pattern and what fills the pattern's holes, each read in turn.
struct Reading {
  const char* pattern = nullptr;  ///< null: no pattern fits, and `text` is all there is
  std::string text;
  std::vector<Reading> parts;  ///< for %1, %2, ...
};

/// Any thread may read.
class SentenceReader {
 public:
  /// Patterns are UTF-8 with the holes %1, %2, ... in this order, none beside another, and outlive
  /// the reader.
  explicit SentenceReader(const std::vector<const char*>& patterns);

  /// Of all ways to read the text the one whose patterns account for most of its letters. A pattern
  /// with few letters of its own is believed only where each hole holds a word, a number, or what
  /// is recognised itself. Where there are many sentences, a pattern is looked for in a few of them
  /// at a time.
  [[nodiscard]] Reading read(std::string_view text) const;

 private:
  struct Pattern {
    const char* source;
    std::vector<std::string> pieces;  ///< before, between and after the holes
    std::vector<bool> is_name;        ///< of each hole: stands between quotes
    int letters;
  };
  class Search;

  std::vector<Pattern> patterns_;
  std::unordered_map<std::string_view, const Pattern*> whole_;      ///< without holes, by text
  std::unordered_map<char, std::vector<const Pattern*>> by_first_;  ///< that begin with a letter
  std::vector<const Pattern*> open_;                                ///< that begin with a hole
  const Pattern* row_ = nullptr;                                    ///< "%1. %2"
};

}  // namespace alltact
