#include "core/either.h"

#include <algorithm>

namespace alltact {
namespace {

constexpr std::size_t kLongestWord = 60;  // a longer input is no typing error

/// Edit distance (optimal string alignment): insertions, deletions, substitutions and swaps of
/// neighbours.
std::size_t letters_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::move(last);
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool is_same = a[i - 1] == b[j - 1];
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (is_same ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

Message either(const std::vector<std::string>& words) {
  Message all;
  for (const std::string& word : words)
    all = all.empty() ? Message::typed(word) : en::say("{} or {}", all, word);
  return all;
}

std::string nearest_word(std::string_view given, const std::vector<std::string>& words) {
  std::string nearest;
  if (given.size() > kLongestWord) return nearest;
  std::size_t fewest = kLongestWord;
  for (const std::string& word : words) {
    const std::size_t letters = letters_between(given, word);
    if (letters < fewest && 3 * letters <= word.size()) fewest = letters, nearest = word;
  }
  return nearest;
}

Message one_of(const std::vector<std::string>& words, std::string_view given) {
  const Message all = en::say("one of {}", fmt::format("{}", fmt::join(words, ", ")));
  const std::string nearest = nearest_word(given, words);
  return nearest.empty() ? all : en::say("'{}', or else {}", nearest, all);
}

}  // namespace alltact
