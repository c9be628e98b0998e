// What the program says, told apart from the language it is said in.
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

/// A sentence or phrase as its template, as it stands in the source, and what fills the template's
/// holes. Command line and files take english(); a window translates the template, then the parts
/// that are messages themselves. What a person typed or the system says is text, which no language
/// changes. Immutable but for assignment; any thread.
class Message {
 public:
  /// Nothing said.
  Message() = default;
  Message(const char (&/*nothing*/)[1]) {}  // NOLINT: "" is nothing said, in every language

  /// A name, a path, a reason: as it is, in every language.
  [[nodiscard]] static Message typed(std::string text);

  /// What kind of thing was said.
  enum class Kind { kTyped, kNumber, kSaid, kCounted };

  /// Puts a message together from what kind(), words() and so on told of it, perhaps in another
  /// process. `parts` fill the holes of `words`; holes beyond them stay empty.
  [[nodiscard]] static Message put_together(
      Kind kind, std::string words, std::string context, long count, std::vector<Message> parts);

  [[nodiscard]] bool empty() const { return words_.empty(); }
  [[nodiscard]] Kind kind() const { return kind_; }
  /// The template; of text and numbers, what they are.
  [[nodiscard]] const std::string& words() const { return words_; }
  /// Of a word, what it is said of; of what is counted, the template for one.
  [[nodiscard]] const std::string& context() const { return context_; }
  [[nodiscard]] long count() const { return count_; }
  [[nodiscard]] const std::vector<Message>& parts() const { return parts_; }

  [[nodiscard]] std::string english() const;

  /// The words for a message that was said or counted, with holes {} or {0}, {1}, ... for its
  /// parts; what stands after a colon in a hole says how numbers are written, and is passed over.
  using Language = std::function<std::string(const Message&)>;
  [[nodiscard]] std::string in(const Language& language) const;

  [[nodiscard]] bool operator==(const Message&) const = default;

 private:
  Kind kind_ = Kind::kTyped;
  long count_ = -1;
  std::string words_, context_;
  std::vector<Message> parts_;
};

/// Says messages in English. Whatever is said through here, and nothing else, is translated, and
/// lupdate finds it: a template is one literal (of several pieces, where it is long). A message
/// that is said inside another's parentheses must not stand directly behind the template, where
/// lupdate overlooks it: give it a name.
namespace en {

namespace detail {

/// The first hole of the template for this part, alone: "{:.2f}".
std::string hole_of(std::string_view words, std::size_t part);

template <class T>
Message part_of([[maybe_unused]] std::string_view words,
                [[maybe_unused]] std::size_t index,
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
      return Message::put_together(Message::Kind::kNumber, std::move(text), {}, -1, {});
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

/// What fmt is told of a part to check the template by.
template <class T>
using Checked =
    std::conditional_t<std::is_same_v<T, Message> || std::is_same_v<T, std::filesystem::path>,
                       std::string,
                       T>;

template <class... T>
using Words = fmt::format_string<const Checked<T>&...>;

}  // namespace detail

/// A template in fmt's grammar, checked while compiling, and its parts: messages, numbers, and
/// text that somebody typed.
template <class... T>
[[nodiscard]] Message say(std::type_identity_t<detail::Words<T...>> words, const T&... parts) {
  const fmt::string_view text = words;
  return Message::put_together(Message::Kind::kSaid,
                               std::string(text.data(), text.size()),
                               {},
                               -1,
                               detail::parts_of({text.data(), text.size()}, parts...));
}

/// `many` or, of one thing, `one`: both have the same holes, and the first is for the count, or
/// for {0}.
template <class N, class... T>
[[nodiscard]] Message count(std::type_identity_t<detail::Words<N, T...>> many,
                            std::type_identity_t<detail::Words<N, T...>> one,
                            N count,
                            const T&... parts) {
  static_assert(std::is_integral_v<N>);
  const fmt::string_view text = many, single = one;
  return Message::put_together(Message::Kind::kCounted,
                               std::string(text.data(), text.size()),
                               std::string(single.data(), single.size()),
                               static_cast<long>(count),
                               detail::parts_of({text.data(), text.size()}, count, parts...));
}

/// A word that other languages bend by what it is said of, as "left" of a press and of a third.
[[nodiscard]] Message word(const char* word, const char* said_of);

/// "a, b, c"; empty messages are left out.
[[nodiscard]] Message list(const std::vector<Message>& messages);
/// "a; b; c"
[[nodiscard]] Message clauses(const std::vector<Message>& messages);
/// "a. b. c", without the last full stop.
[[nodiscard]] Message sentences(const std::vector<Message>& messages);
/// "place: what"; `what` alone where the place is empty.
[[nodiscard]] Message at(const Message& place, const Message& what);

}  // namespace en
}  // namespace alltact

/// lupdate looks for en from here in functions that return another library's class.
namespace en = alltact::en;

/// In English, so that what is written for terminals and files can be put together with fmt.
template <>
struct fmt::formatter<alltact::Message> : fmt::formatter<std::string> {
  template <class Context>
  auto format(const alltact::Message& message, Context& context) const {
    return fmt::formatter<std::string>::format(message.english(), context);
  }
};
