#include "core/base/message.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace alltact {
namespace {

/// A hole of a template: its range in the text, and the number of its part.
struct Hole {
  std::size_t begin, end;
  std::size_t part;
};

/// The next hole from `begin` on; `next` is the part for a hole without a number.
std::optional<Hole> next_hole(std::string_view words, std::size_t begin, std::size_t& next) {
  for (std::size_t i = begin; i < words.size(); ++i) {
    if (words[i] == '{' && words.substr(i + 1).starts_with('{')) {
      ++i;
    } else if (words[i] == '{') {
      const std::size_t end = words.find('}', i);
      if (end == std::string_view::npos) return std::nullopt;
      std::size_t part = next;
      const char* const first = words.data() + i + 1;
      if (std::from_chars(first, words.data() + end, part).ptr == first) ++next;
      return Hole{i, end + 1, part};
    }
  }
  return std::nullopt;
}

void append_unescaped(std::string& text, std::string_view words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += words[i];
    if ((words[i] == '{' || words[i] == '}') && words.substr(i + 1).starts_with(words[i])) ++i;
  }
}

std::string filled(std::string_view words, const std::vector<Message>& parts,
                   const Message::Language& language) {
  std::string text;
  std::size_t begin = 0, next = 0;
  while (const auto hole = next_hole(words, begin, next)) {
    append_unescaped(text, words.substr(begin, hole->begin - begin));
    if (hole->part < parts.size()) text += parts[hole->part].in(language);
    begin = hole->end;
  }
  append_unescaped(text, words.substr(begin));
  return text;
}

/// Joins the messages in their order; `join` joins two.
template <class Join>
Message joined(const std::vector<Message>& messages, Join join) {
  Message all;
  for (auto message = messages.rbegin(); message != messages.rend(); ++message) {
    if (message->empty()) continue;
    all = all.empty() ? *message : join(*message, all);
  }
  return all;
}

}  // namespace

Message Message::typed(std::string text) {
  return compose(Kind::kTyped, std::move(text), {}, -1, {});
}

Message Message::compose(Kind kind, std::string words, std::string context, long count,
                         std::vector<Message> parts) {
  Message message;
  message.kind_ = kind;
  message.words_ = std::move(words);
  message.context_ = std::move(context);
  message.count_ = count;
  message.parts_ = std::move(parts);
  return message;
}

std::string Message::in(const Language& language) const {
  if (kind_ == Kind::kTyped || kind_ == Kind::kNumber) return words_;
  return filled(language(*this), parts_, language);
}

std::string Message::english() const {
  return in([](const Message& message) {
    return message.kind_ == Kind::kCounted && message.count_ == 1 ? message.context_
                                                                  : message.words_;
  });
}

namespace en {
namespace detail {

std::string hole_of(std::string_view words, std::size_t part) {
  std::size_t begin = 0, next = 0;
  while (const auto hole = next_hole(words, begin, next)) {
    begin = hole->end;
    if (hole->part != part) continue;
    const std::string_view inside = words.substr(hole->begin, hole->end - hole->begin);
    const std::size_t colon = inside.find(':');
    if (colon == std::string_view::npos) return "{}";
    std::string alone = "{";
    return alone.append(inside.substr(colon));
  }
  return "{}";
}

}  // namespace detail

Message word(const char* word, const char* context) {
  return Message::compose(Message::Kind::kTemplate, word, context, -1, {});
}

Message list(const std::vector<Message>& messages) {
  return joined(messages,
                [](const Message& a, const Message& b) { return en::say("{}, {}", a, b); });
}

Message clauses(const std::vector<Message>& messages) {
  return joined(messages,
                [](const Message& a, const Message& b) { return en::say("{}; {}", a, b); });
}

Message sentences(const std::vector<Message>& messages) {
  return joined(messages,
                [](const Message& a, const Message& b) { return en::say("{}. {}", a, b); });
}

Message at(const Message& where, const Message& what) {
  return where.empty() ? what : en::say("{}: {}", where, what);
}

}  // namespace en

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

namespace {

/// Bytes of the text's first UTF-8 character; 0 where it is invalid, or a control character (one
/// byte, or U+0080 to U+009F).
std::size_t printable_bytes(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  const std::size_t size = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  const bool is_overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool is_beyond = (first == 0xED && byte(1) >= 0xA0) || (first == 0xF4 && byte(1) >= 0x90);
  const bool is_control = first == 0xC2 && byte(1) < 0xA0;
  return is_overlong || is_beyond || is_control ? 0 : size;
}

std::string escaped(char c) {
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  return fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::string_view kCut = "...";
  std::string result;
  std::size_t shown = 0, cut_at = 0;  // length at which a too long text is cut
  while (!text.empty()) {
    const std::size_t bytes = printable_bytes(text);
    const std::string one = bytes > 0 ? std::string(text.substr(0, bytes)) : escaped(text[0]);
    shown += bytes > 0 ? 1 : one.size();
    if (shown > kMaxPrinted) {
      result.resize(cut_at);
      result += kCut;
      break;
    }
    result += one;
    if (shown <= kMaxPrinted - kCut.size()) cut_at = result.size();
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

}  // namespace alltact
