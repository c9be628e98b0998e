// Messages of the program, separate from the language in which they are shown.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

namespace alltact {

/// A sentence or phrase: its template as it stands in the source, and the parts that fill the
/// template's holes. Command line and files use english(). A window translates the template, then
/// the parts that are messages themselves. Text typed by a person or from the system is the same in
/// every language. Immutable but for assignment; any thread.
class Message {
 public:
  /// An empty message.
  Message() = default;
  Message(const char (&/*nothing*/)[1]) {}  // NOLINT: "" is empty in every language

  /// A name, a path, a reason: the same in every language.
  [[nodiscard]] static Message typed(std::string text);

  /// Origin of the message's words.
  enum class Kind { kTyped, kNumber, kTemplate, kCounted };

  /// Composes a message from the values of kind(), words() and so on, for example from another
  /// process. `parts` fill the holes of `words`; surplus holes stay empty.
  [[nodiscard]] static Message compose(Kind kind, std::string words, std::string context,
                                       long count, std::vector<Message> parts);

  [[nodiscard]] bool empty() const { return words_.empty(); }
  [[nodiscard]] Kind kind() const { return kind_; }
  /// The template; for text and numbers, their characters.
  [[nodiscard]] const std::string& words() const { return words_; }
  /// For a word, the thing it describes; for a counted thing, the singular template.
  [[nodiscard]] const std::string& context() const { return context_; }
  [[nodiscard]] long count() const { return count_; }
  [[nodiscard]] const std::vector<Message>& parts() const { return parts_; }

  [[nodiscard]] std::string english() const;

  /// Returns the template of a message in a language, with holes {} or {0}, {1}, ... for its parts.
  /// The format after a colon in a hole is ignored.
  using Language = std::function<std::string(const Message&)>;
  [[nodiscard]] std::string in(const Language& language) const;

  [[nodiscard]] bool operator==(const Message&) const = default;

 private:
  Kind kind_ = Kind::kTyped;
  long count_ = -1;
  std::string words_, context_;
  std::vector<Message> parts_;
};

/// Messages in English. Exactly the messages made by these functions are translated. lupdate finds
/// them: a template is one literal (of several pieces, where it is long). lupdate overlooks a
/// message made directly behind another's template, inside its parentheses: give that message a
/// name.
namespace en {

namespace detail {

/// The first hole of the template for this part, by itself: "{:.2f}".
std::string hole_of(std::string_view words, std::size_t part);

template <class T>
Message part_of([[maybe_unused]] std::string_view words, [[maybe_unused]] std::size_t index,
                const T& part) {
  static_assert(!std::is_array_v<T> && !std::is_pointer_v<T>,
                "text in a hole is a message of its own, or a std::string that somebody typed");
  if constexpr (std::is_same_v<T, Message>) {
    return part;
  } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
    return Message::typed(part.string());
  } else {
    std::string text = fmt::format(fmt::runtime(hole_of(words, index)), part);
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, char>)
      return Message::compose(Message::Kind::kNumber, std::move(text), {}, -1, {});
    else
      return Message::typed(std::move(text));
  }
}

template <class... T>
std::vector<Message> parts_of([[maybe_unused]] std::string_view words, const T&... parts) {
  std::vector<Message> all;
  all.reserve(sizeof...(parts));
  (all.push_back(part_of(words, all.size(), parts)), ...);
  return all;
}

/// The type with which fmt checks a part against the template.
template <class T>
using Checked =
    std::conditional_t<std::is_same_v<T, Message> || std::is_same_v<T, std::filesystem::path>,
                       std::string, T>;

template <class... T>
using Words = fmt::format_string<const Checked<T>&...>;

}  // namespace detail

/// A template in fmt's grammar, checked at compile time, and its parts: messages, numbers, and text
/// that somebody typed.
template <class... T>
[[nodiscard]] Message say(std::type_identity_t<detail::Words<T...>> words, const T&... parts) {
  const fmt::string_view text = words;
  return Message::compose(Message::Kind::kTemplate, std::string(text.data(), text.size()), {}, -1,
                          detail::parts_of({text.data(), text.size()}, parts...));
}

/// Uses `many` or, for a count of one, `one`. Both have the same holes; the first is for the count,
/// or for {0}.
template <class N, class... T>
[[nodiscard]] Message count(std::type_identity_t<detail::Words<N, T...>> many,
                            std::type_identity_t<detail::Words<N, T...>> one, N count,
                            const T&... parts) {
  static_assert(std::is_integral_v<N>);
  const fmt::string_view text = many, single = one;
  return Message::compose(Message::Kind::kCounted, std::string(text.data(), text.size()),
                          std::string(single.data(), single.size()), static_cast<long>(count),
                          detail::parts_of({text.data(), text.size()}, count, parts...));
}

/// A word whose translation depends on the thing it describes, as "left" of a press and of a third.
[[nodiscard]] Message word(const char* word, const char* context);

/// Returns "a, b, c"; empty messages are left out.
[[nodiscard]] Message list(const std::vector<Message>& messages);
/// "a; b; c"
[[nodiscard]] Message clauses(const std::vector<Message>& messages);
/// "a. b. c", without the last full stop.
[[nodiscard]] Message sentences(const std::vector<Message>& messages);
/// Returns "where: what"; `what` by itself where the first is empty.
[[nodiscard]] Message at(const Message& where, const Message& what);

}  // namespace en

// Lists of alternative words for messages, and the nearest word to a mistyped one.

/// Returns "a or b or c". The words are those of files and flags, alike in every language.
[[nodiscard]] Message either(const std::vector<std::string>& words);

/// Returns the word with the smallest edit distance to `given`, at most a third of its letters.
/// Otherwise returns an empty string. Two swapped neighbours count as one edit.
[[nodiscard]] std::string nearest_word(std::string_view given,
                                       const std::vector<std::string>& words);

/// Returns "one of a, b, c", preceded by the word that is nearest to `given`.
[[nodiscard]] Message one_of(const std::vector<std::string>& words, std::string_view given = {});

// Foreign text made safe for messages.

/// Maximum number of a value's characters that a message repeats.
inline constexpr std::size_t kMaxPrinted = 60;

/// Returns the text on one line. Control characters and bytes that are not UTF-8 become
/// , \t or \x1b, so that no file controls a terminal. A text above kMaxPrinted characters is cut
/// and ends in "...".
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace alltact

/// Makes lupdate find en in functions that return another library's class.
namespace en = alltact::en;

/// In English, so that fmt can compose texts for terminals and files.
template <>
struct fmt::formatter<alltact::Message> : fmt::formatter<std::string> {
  template <class Context>
  auto format(const alltact::Message& message, Context& context) const {
    return fmt::formatter<std::string>::format(message.english(), context);
  }
};
