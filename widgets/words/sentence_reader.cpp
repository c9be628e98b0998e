#include "widgets/words/sentence_reader.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

namespace alltact {
namespace {

constexpr int kFewLetters = 12;
constexpr int kMostTries = 200;  // of one pattern on one text
constexpr std::string_view kRow = "%1. %2";
constexpr std::string_view kEnd = ". ";
constexpr std::size_t kMostSentences = 4;  // in which one pattern is looked for

int letters_in(std::string_view text) {
  return static_cast<int>(std::count_if(text.begin(), text.end(), [](char letter) {
    return std::isalpha(static_cast<unsigned char>(letter)) != 0;
  }));
}

bool is_hole(std::string_view text, std::size_t at) {
  return text[at] == '%' && at + 1 < text.size() && text[at + 1] >= '1' && text[at + 1] <= '9';
}

std::vector<std::string> pieces_of(std::string_view pattern) {
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (is_hole(pattern, i)) {
      pieces.emplace_back();
      ++i;
    } else {
      pieces.back() += pattern[i];
    }
  }
  return pieces;
}

}  // namespace

SentenceReader::SentenceReader(const std::vector<const char*>& patterns) {
  patterns_.reserve(patterns.size());  // others point into it
  for (const char* source : patterns) {
    Pattern pattern{source, pieces_of(source), {}, letters_in(source)};
    for (std::size_t i = 1; i < pattern.pieces.size(); ++i)
      pattern.is_name.push_back(pattern.pieces[i - 1].ends_with('\'') &&
                                pattern.pieces[i].starts_with('\''));
    patterns_.push_back(std::move(pattern));
    const Pattern* kept = &patterns_.back();
    if (kept->pieces.size() == 1) {
      whole_.emplace(kept->source, kept);
    } else if (kept->pieces.front().empty()) {
      open_.push_back(kept);
      if (kept->source == kRow) row_ = kept;
    } else {
      by_first_[kept->pieces.front().front()].push_back(kept);
    }
  }
}

/// Finds the best reading of a text and of every part of it that is looked at, each once.
class SentenceReader::Search {
 public:
  Search(const SentenceReader& reader, std::string_view text) : reader_(reader), text_(text) {}

  /// As many letters of the text as the best reading accounts for.
  [[nodiscard]] int letters_of(std::size_t begin, std::size_t end) {
    return look_at(begin, end).letters;
  }

  [[nodiscard]] Reading reading_of(std::size_t begin, std::size_t end) {
    const Best best = look_at(begin, end);
    Reading reading{nullptr, std::string(text_.substr(begin, end - begin)), {}};
    if (best.pattern == nullptr) return reading;
    reading.pattern = best.pattern->source;
    for (std::size_t i = 0; i < best.holes.size(); ++i) {
      const auto [from, to] = best.holes[i];
      reading.parts.push_back(best.pattern->is_name[i]
                                  ? Reading{nullptr, std::string(text_.substr(from, to - from)), {}}
                                  : reading_of(from, to));
    }
    return reading;
  }

 private:
  using Span = std::pair<std::size_t, std::size_t>;
  struct Best {
    const Pattern* pattern = nullptr;
    std::vector<Span> holes;
    int letters = 0;
  };

  const Best& look_at(std::size_t begin, std::size_t end) {
    const auto [place, is_new] = seen_.try_emplace({begin, end});
    if (!is_new) return place->second;
    const std::string_view text = text_.substr(begin, end - begin);
    Best best;
    if (const auto whole = reader_.whole_.find(text); whole != reader_.whole_.end())
      best = {whole->second, {}, whole->second->letters};
    if (!text.empty())
      if (const auto some = reader_.by_first_.find(text.front()); some != reader_.by_first_.end())
        for (const Pattern* pattern : some->second) try_pattern(*pattern, begin, end, best);
    for (const Pattern* pattern : reader_.open_) try_pattern(*pattern, begin, end, best);
    return seen_[{begin, end}] = std::move(best);
  }

  void try_pattern(const Pattern& pattern, std::size_t begin, std::size_t end, Best& best) {
    const std::string_view text = text_.substr(begin, end - begin);
    const std::string &first = pattern.pieces.front(), &last = pattern.pieces.back();
    if (text.size() < first.size() + last.size() + pattern.is_name.size() ||
        !text.starts_with(first) || !text.ends_with(last))
      return;
    std::vector<Span> holes;
    int tries = 0;
    place(pattern, begin + first.size(), end - last.size(), holes, tries, best);
  }

  /// Places the pieces after the holes that have their places; `from`: where the next hole begins.
  void place(const Pattern& pattern,
             std::size_t from,
             std::size_t end,
             std::vector<Span>& holes,
             int& tries,
             Best& best) {
    const std::size_t next = holes.size() + 1;
    if (next + 1 == pattern.pieces.size()) {
      if (from >= end || ++tries > kMostTries) return;
      holes.emplace_back(from, end);
      weigh(pattern, holes, best);
      holes.pop_back();
      return;
    }
    const std::string& piece = pattern.pieces[next];
    const std::string_view text = text_.substr(0, end);
    for (std::size_t at = text.find(piece, from + 1);
         at != std::string_view::npos && tries <= kMostTries;
         at = text.find(piece, at + 1)) {
      holes.emplace_back(from, at);
      place(pattern, at + piece.size(), end, holes, tries, best);
      holes.pop_back();
    }
  }

  /// Between readings that account for as many letters: a whole sentence, then what joins
  /// sentences, then whoever says more itself.
  static int rank_of(const Pattern& pattern) {
    if (pattern.is_name.empty()) return 1 << 30;
    return pattern.letters == 0 ? 1 << 29 : pattern.letters;
  }

  void weigh(const Pattern& pattern, const std::vector<Span>& holes, Best& best) {
    int letters = pattern.letters;
    bool is_plain = true;
    for (std::size_t i = 0; i < holes.size(); ++i) {
      const auto [from, to] = holes[i];
      const int inside = pattern.is_name[i] ? 0 : look_at(from, to).letters;
      letters += inside;
      is_plain = is_plain &&
                 (inside > 0 || text_.substr(from, to - from).find(' ') == std::string_view::npos);
    }
    if (pattern.letters > 0 && pattern.letters < kFewLetters && !is_plain) return;
    if (letters > best.letters ||
        (letters == best.letters && letters > 0 && rank_of(pattern) > rank_of(*best.pattern)))
      best = {&pattern, holes, letters};
  }

  const SentenceReader& reader_;
  std::string_view text_;
  std::map<Span, Best> seen_;
};

Reading SentenceReader::read(std::string_view text) const {
  Search search(*this, text);
  std::vector<std::size_t> begins{0};
  for (std::size_t at = text.find(kEnd); at != std::string_view::npos; at = text.find(kEnd, at + 1))
    begins.push_back(at + kEnd.size());
  const std::size_t count = begins.size();
  if (row_ == nullptr || count <= kMostSentences) return search.reading_of(0, text.size());
  const auto end_of = [&](std::size_t next) {
    return next < count ? begins[next] - kEnd.size() : text.size();
  };
  // From the back: how many letters the best grouping accounts for, and where its next group
  // begins.
  std::vector<int> letters(count + 1);
  std::vector<std::size_t> next(count);
  for (std::size_t i = count; i-- > 0;) {
    letters[i] = -1;
    for (std::size_t k = i + 1; k <= std::min(i + kMostSentences, count); ++k) {
      const int sum = search.letters_of(begins[i], end_of(k)) + letters[k];
      if (sum > letters[i]) letters[i] = sum, next[i] = k;
    }
  }
  if (letters[0] == 0) return {nullptr, std::string(text), {}};
  std::vector<Reading> groups;
  for (std::size_t i = 0; i < count; i = next[i])
    groups.push_back(search.reading_of(begins[i], end_of(next[i])));
  Reading row = std::move(groups.back());
  for (std::size_t i = groups.size() - 1; i-- > 0;) {
    std::vector<Reading> parts{std::move(groups[i]), std::move(row)};
    row = {row_->source, {}, std::move(parts)};
  }
  return row;
}

}  // namespace alltact
