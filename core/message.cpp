#include "core/message.h"

#include <cassert>
#include <charconv>
#include <optional>
#include <utility>

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

std::string filled(std::string_view words,
                   const std::vector<Message>& parts,
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

Message Message::compose(
    Kind kind, std::string words, std::string context, long count, std::vector<Message> parts) {
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
}  // namespace alltact
