// Settings, each declared once: flag, key in files, help and check derive from it.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/typed_number.h"

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

/// Permitted values: an interval of numbers, one of several words, or something else.
struct SettingRange {
  struct Numbers {
    double low, high;  ///< both ends are permitted
    bool is_integer;   ///< integers only
  };
  std::optional<Numbers> numbers;
  std::vector<std::string> words;  ///< empty for numbers
  std::string other;               ///< description of values that are neither numbers nor words

  /// "1 to 64" or "nearest or local"
  [[nodiscard]] std::string text() const {
    if (numbers) return fmt::format("{} to {}", numbers->low, numbers->high);
    return words.empty() ? other : either(words).english();
  }
};

/// The trade-off of a setting between accuracy and time. It holds what is true for every finger and
/// computer; the study measures the figures for one of each.
struct TradeOff {
  Message gains;                        ///< benefit of a higher value or of each word, and when
  Message costs;                        ///< cost of that
  std::vector<std::string> tried;       ///< values for a study, cheapest first, with the default
  std::vector<std::string> alone = {};  ///< those of them that are too slow to combine with other
                                        ///< settings
  /// False: every value gives the same result on this finger. Empty: it has an effect on all
  /// fingers.
  std::function<bool(const Finger&)> matters = nullptr;
};

/// One setting of a group S.
template <class S>
struct Setting {
  std::string name;  ///< flag (--name) and key, words joined by '-'
  Message sentence;  ///< description for help and dialogs
  SettingRange range;
  std::function<std::string(const S&)> get;
  /// Error: outside the range, or not a value at all.
  std::function<Status(S&, std::string_view)> set;
  /// Its value in words: "half the pixels per side". Empty for settings that no study varies.
  std::function<Message(const S&)> phrase = nullptr;
  std::optional<TradeOff> trade = std::nullopt;  ///< absent: it has no trade-off between accuracy
                                                 ///< and time

  [[nodiscard]] std::string default_value() const { return get(S{}); }
};

/// A number in [low, high]. `member` points to an arithmetic member of S.
template <class S, class T>
Setting<S> number_setting(std::string name, Message sentence, T S::*member, T low, T high,
                          std::type_identity_t<std::function<Message(T)>> phrase = nullptr) {
  Setting<S> setting{std::move(name), std::move(sentence), {}, {}, {}};
  setting.range.numbers = SettingRange::Numbers{static_cast<double>(low), static_cast<double>(high),
                                                std::is_integral_v<T>};
  setting.get = [member](const S& s) { return fmt::format("{}", s.*member); };
  setting.set = [member, low, high, name = setting.name](S& s, std::string_view text) -> Status {
    if (const auto doubt = number_ambiguity(text)) return Error{*doubt, name, ""};
    const auto plain = std::is_integral_v<T> ? plain_integer(text) : plain_number(text);
    T value{};
    const bool is_read =
        plain &&
        std::from_chars(plain->data(), plain->data() + plain->size(), value).ec == std::errc{};
    if (!is_read || !(value >= low && value <= high))
      return Error{en::say("'{}' is not a number from {} to {}", printable(text), low, high), name,
                   ""};
    s.*member = value;
    return {};
  };
  if (phrase)
    setting.phrase = [member, phrase = std::move(phrase)](const S& s) { return phrase(s.*member); };
  return setting;
}

/// A non-empty text, for example a file name.
template <class S>
Setting<S> text_setting(std::string name, Message sentence, std::string S::*member,
                        std::string range, std::function<Message(const std::string&)> phrase) {
  Setting<S> setting{std::move(name), std::move(sentence), {}, {}, {}};
  setting.range.other = std::move(range);
  setting.get = [member](const S& s) { return s.*member; };
  setting.set = [member, name = setting.name](S& s, std::string_view text) -> Status {
    if (text.empty()) return Error{en::say("it is empty"), name, ""};
    s.*member = text;
    return {};
  };
  setting.phrase = [member, phrase = std::move(phrase)](const S& s) { return phrase(s.*member); };
  return setting;
}

/// One value of a choice.
template <class E>
struct Choice {
  std::string word;  ///< of flags and files
  E value;
  Message phrase = {};  ///< see Setting::phrase
};

/// One of several words.
template <class S, class E>
Setting<S> choice_setting(std::string name, Message sentence, E S::*member,
                          std::vector<Choice<E>> choices) {
  Setting<S> setting{std::move(name), std::move(sentence), {}, {}, {}};
  for (const Choice<E>& choice : choices) setting.range.words.push_back(choice.word);
  const Message range = either(setting.range.words);
  setting.get = [member, choices](const S& s) -> std::string {
    for (const auto& choice : choices)
      if (choice.value == s.*member) return choice.word;
    return {};
  };
  setting.set = [member, choices, range, name = setting.name](S& s,
                                                              std::string_view text) -> Status {
    for (const auto& choice : choices)
      if (choice.word == text) return s.*member = choice.value, Status{};
    return Error{en::say("'{}' is not {}", printable(text), range), name, ""};
  };
  setting.phrase = [member, choices = std::move(choices)](const S& s) -> Message {
    for (const auto& choice : choices)
      if (choice.value == s.*member) return choice.phrase;
    return {};
  };
  return setting;
}

/// True when the setting has a trade-off on this finger.
template <class S>
bool has_trade_off(const Setting<S>& setting, const Finger& finger) {
  return setting.trade && (!setting.trade->matters || setting.trade->matters(finger));
}

/// Returns the setting with its trade-off.
template <class S>
Setting<S> with_trade_off(Setting<S> setting, TradeOff trade) {
  setting.trade = std::move(trade);
  return setting;
}

}  // namespace alltact
