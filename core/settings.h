// A named choice, declared once: its flag, its key in files, its help and its check come from here.
#pragma once

#include "core/either.h"
#include "core/message.h"
#include "core/printable.h"
#include "core/result.h"
#include "core/typed_number.h"

#include <charconv>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace alltact {

class Finger;

/// What can be set: a number between two others, one of several words, or something else.
struct SettingRange {
  struct Numbers {
    double low, high;  ///< both can be set
    bool whole;        ///< whole numbers alone
  };
  std::optional<Numbers> numbers;
  std::vector<std::string> words;  ///< empty for numbers
  std::string other;               ///< in words, of what is neither

  /// "1 to 64" or "nearest or local"
  [[nodiscard]] std::string text() const {
    if (numbers) return fmt::format("{} to {}", numbers->low, numbers->high);
    return words.empty() ? other : either(words).english();
  }
};

/// Of a setting that trades accuracy for time. Figures are the study's to tell, of one finger on
/// one computer; here stands what does not hang on either.
struct Trade {
  Message gains;                        ///< what more of it brings, or which of the words, and when
  Message costs;                        ///< what that takes
  std::vector<std::string> tried;       ///< what a study looks at, cheapest first, with the default
  std::vector<std::string> alone = {};  ///< of these, what is too slow to be tried beside others
  /// False: on this finger every value of it does the same. Empty: it matters on all.
  std::function<bool(const Finger&)> matters = nullptr;
};

/// One choice within a group S of settings.
template <class S>
struct Setting {
  std::string name;  ///< as flag (--name) and as key, words joined by '-'
  Message sentence;  ///< what it does, for help and dialogs
  SettingRange range;
  std::function<std::string(const S&)> get;
  /// Error: outside the range, or not a value at all.
  std::function<Status(S&, std::string_view)> set;
  std::optional<Trade> trade = std::nullopt;  ///< absent: it does not trade accuracy for time

  [[nodiscard]] std::string default_value() const { return get(S{}); }
};

/// A number in [low, high]. `member` is a pointer to an arithmetic member of S.
template <class S, class T>
Setting<S> number_setting(std::string name, Message sentence, T S::*member, T low, T high) {
  Setting<S> setting{std::move(name), std::move(sentence), {}, {}, {}};
  setting.range.numbers = SettingRange::Numbers{
      static_cast<double>(low), static_cast<double>(high), std::is_integral_v<T>};
  setting.get = [member](const S& s) { return fmt::format("{}", s.*member); };
  setting.set = [member, low, high, name = setting.name](S& s, std::string_view text) -> Status {
    if (const auto doubt = doubt_of_number(text)) return Error{*doubt, name, ""};
    const auto plain = std::is_integral_v<T> ? plain_whole_number(text) : plain_number(text);
    T value{};
    const bool is_read =
        plain &&
        std::from_chars(plain->data(), plain->data() + plain->size(), value).ec == std::errc{};
    if (!is_read || !(value >= low && value <= high))
      return Error{
          en::say("'{}' is not a number from {} to {}", printable(text), low, high), name, ""};
    s.*member = value;
    return {};
  };
  return setting;
}

/// A name, of a file for instance: anything but nothing.
template <class S>
Setting<S> text_setting(std::string name,
                        Message sentence,
                        std::string S::*member,
                        std::string range) {
  Setting<S> setting{std::move(name), std::move(sentence), {}, {}, {}};
  setting.range.other = std::move(range);
  setting.get = [member](const S& s) { return s.*member; };
  setting.set = [member, name = setting.name](S& s, std::string_view text) -> Status {
    if (text.empty()) return Error{en::say("it is empty"), name, ""};
    s.*member = text;
    return {};
  };
  return setting;
}

/// One of several words.
template <class S, class E>
Setting<S> choice_setting(std::string name,
                          Message sentence,
                          E S::*member,
                          std::vector<std::pair<std::string, E>> words) {
  Setting<S> setting{std::move(name), std::move(sentence), {}, {}, {}};
  for (const auto& [word, value] : words) setting.range.words.push_back(word);
  const Message range = either(setting.range.words);
  setting.get = [member, words](const S& s) -> std::string {
    for (const auto& [word, value] : words)
      if (value == s.*member) return word;
    return {};
  };
  setting.set = [member, words, range, name = setting.name](S& s, std::string_view text) -> Status {
    for (const auto& [word, value] : words)
      if (word == text) return s.*member = value, Status{};
    return Error{en::say("'{}' is not {}", printable(text), range), name, ""};
  };
  return setting;
}

/// Whether a setting trades anything on this finger.
template <class S>
bool trades_on(const Setting<S>& setting, const Finger& finger) {
  return setting.trade && (!setting.trade->matters || setting.trade->matters(finger));
}

/// With what is known of its trade.
template <class S>
Setting<S> trading(Setting<S> setting, Trade trade) {
  setting.trade = std::move(trade);
  return setting;
}

}  // namespace alltact
