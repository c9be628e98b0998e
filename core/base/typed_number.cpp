#include "core/base/typed_number.h"

#include "core/base/letters.h"
#include "core/base/message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace alltact {
namespace {

/// Characters that are equivalent to one of ASCII. Invisible ones become blanks, which are valid
/// only around a number.
constexpr std::array<std::pair<std::string_view, char>, 40> kAlike{{
    {"０", '0'},     {"１", '1'},     {"２", '2'},     {"３", '3'},     {"４", '4'},
    {"５", '5'},     {"６", '6'},     {"７", '7'},     {"８", '8'},     {"９", '9'},
    {"．", '.'},     {"。", '.'},     {"｡", '.'},      {"，", ','},     {"＋", '+'},
    {"－", '-'},     {"−", '-'},      {"–", '-'},      {"﹣", '-'},     {"‐", '-'},
    {"‑", '-'},      {"’", '\''},     {"＇", '\''},    {"‘", '\''},     {"ʼ", '\''},
    {"％", '%'},     {"\u00A0", ' '}, {"\u2002", ' '}, {"\u2003", ' '}, {"\u2007", ' '},
    {"\u2008", ' '}, {"\u2009", ' '}, {"\u200A", ' '}, {"\u200E", ' '}, {"\u200F", ' '},
    {"\u202F", ' '}, {"\u2060", ' '}, {"\u3000", ' '}, {"\uFEFF", ' '}, {"\t", ' '},
}};

std::string in_ascii(std::string_view text) {
  std::string ascii;
  while (!text.empty()) {
    const auto alike = std::find_if(kAlike.begin(), kAlike.end(),
                                    [&](const auto& pair) { return text.starts_with(pair.first); });
    const bool is_alike = alike != kAlike.end();
    ascii += is_alike ? alike->second : text.front();
    text.remove_prefix(is_alike ? alike->first.size() : 1);
  }
  return ascii;
}

bool is_digit_at(std::string_view text, std::size_t at) {
  return at < text.size() && is_digit(text[at]);
}

/// The parts of "-1.234,5e3 mm".
struct Parts {
  bool is_negative = false;
  std::vector<std::string> groups;  // digits; the first and the last group may be empty
  std::string marks;                // between the groups
  std::string exponent;             // "e3"
  std::string rest;                 // without blanks at its ends
};

Parts parts_of(std::string_view text) {
  Parts parts;
  if (text.starts_with('+') || text.starts_with('-')) {
    parts.is_negative = text.front() == '-';
    text.remove_prefix(1);
  }
  parts.groups.emplace_back();
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    // A blank, an apostrophe and an underscore belong to the number only between two digits.
    const bool is_inside = at > 0 && is_digit(text[at - 1]) && is_digit_at(text, at + 1);
    if (is_digit(c)) {
      parts.groups.back() += c;
    } else if (c == '.' || c == ',' || (is_inside && (c == ' ' || c == '\'' || c == '_'))) {
      parts.marks += c;
      parts.groups.emplace_back();
    } else {
      break;
    }
  }
  text.remove_prefix(at);
  if (text.starts_with('e') || text.starts_with('E')) {
    const bool has_sign = text.size() > 1 && (text[1] == '+' || text[1] == '-');
    const std::size_t first = has_sign ? 2 : 1;
    std::size_t end = first;
    while (is_digit_at(text, end)) ++end;
    if (end > first) {
      parts.exponent = has_sign && text[1] == '-' ? "e-" : "e";
      parts.exponent += text.substr(first, end - first);
      text.remove_prefix(end);
    }
  }
  parts.rest = trimmed(text, " ");
  return parts;
}

std::string without_leading_zeros(const std::string& digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

/// Sets the decimal mark behind the first `integer_groups` groups; with all groups there is no
/// mark.
std::string joined_digits(const Parts& parts, std::size_t integer_groups) {
  std::string before, behind;
  for (std::size_t i = 0; i < parts.groups.size(); ++i)
    (i < integer_groups ? before : behind) += parts.groups[i];
  std::string text = parts.is_negative ? "-" : "";
  text += before.empty() ? "0" : without_leading_zeros(before);
  if (!behind.empty()) text += "." + behind;
  return text + parts.exponent;
}

std::optional<double> value_of(std::string_view plain) {
  double value = 0;
  const auto [end, status] = std::from_chars(plain.data(), plain.data() + plain.size(), value);
  if (status != std::errc{} || end != plain.data() + plain.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

Error not_a_number(std::string_view text) {
  if (trimmed(in_ascii(text), " ").empty()) return {en::say("a number is missing"), "", ""};
  return {en::say("'{}' is not a number", printable(text)), "", ""};
}

/// A text with several marks: suggests the number without thousands marks.
Error grouped(std::string_view text, const Parts& parts) {
  const std::size_t last = parts.marks.size() - 1;
  const bool is_decimal = (parts.marks[last] == '.' || parts.marks[last] == ',') &&
                          parts.marks.find(parts.marks[last]) == last;
  const std::size_t integer_groups = is_decimal && last > 0 ? last + 1 : parts.groups.size();
  const auto is_of_three = [](const std::string& group) { return group.size() == 3; };
  const auto first = parts.groups.begin(),
             end = first + static_cast<std::ptrdiff_t>(integer_groups);
  const bool is_one_kind = parts.marks.find_first_not_of(parts.marks[0]) >= integer_groups - 1;
  if (first->empty() || first->size() > 3 || !is_one_kind ||
      !std::all_of(first + 1, end, is_of_three))
    return not_a_number(text);
  const auto meant = value_of(joined_digits(parts, integer_groups));
  if (!meant) return not_a_number(text);
  return {en::say("'{}' contains a thousands separator: write {}", printable(text), *meant), "",
          ""};
}

bool may_be_thousands(const Parts& parts, DecimalMark mark) {
  const char of_thousands = mark == DecimalMark::kPoint ? ',' : '.';
  const std::string& integer_part = parts.groups[0];
  return parts.marks[0] == of_thousands && parts.groups[1].size() == 3 && !integer_part.empty() &&
         integer_part.size() <= 3 && integer_part[0] != '0';
}

std::optional<Error> unit_problem(std::string_view text, const std::string& rest,
                                  const std::string& unit) {
  if (rest.empty() || rest == trimmed(in_ascii(unit), " ")) return std::nullopt;
  // "1/2" and "4x5" are no numbers with units.
  const bool is_word =
      std::none_of(rest.begin(), rest.end(), is_digit) &&
      (static_cast<unsigned char>(rest[0]) >= 0x80 || std::isalpha(rest[0]) != 0 || rest[0] == '%');
  if (!is_word) return not_a_number(text);
  if (unit.empty())
    return Error{
        en::say("'{}' has '{}' after the number: remove it", printable(text), printable(rest)), "",
        ""};
  return Error{en::say("'{}' is in '{}': give the number in {}", printable(text), printable(rest),
                       std::string(trimmed(in_ascii(unit), " "))),
               "", ""};
}

}  // namespace

Result<std::string> plain_number(std::string_view text, const NumberFormat& format) {
  const std::string ascii = in_ascii(text);
  const Parts parts = parts_of(trimmed(ascii, " "));
  const bool has_digits = std::any_of(parts.groups.begin(), parts.groups.end(),
                                      [](const auto& g) { return !g.empty(); });
  if (!has_digits) return not_a_number(text);
  if (auto problem = unit_problem(text, parts.rest, format.unit)) return *problem;
  const bool is_grouped =
      parts.marks.size() > 1 || parts.marks.find_first_of("' _") != std::string::npos;
  if (is_grouped) return grouped(text, parts);
  std::string plain = joined_digits(parts, 1);
  const auto value = value_of(plain);
  if (!value)
    return Error{en::say("'{}' is too large or too small a number", printable(text)), "", ""};
  if (!parts.marks.empty() && may_be_thousands(parts, format.mark))
    if (const auto other = value_of(joined_digits(parts, 2)))
      return Error{
          en::say("'{0}' can mean {1} or {2}: write {1} or {2}", printable(text), *value, *other),
          "", ""};
  return plain;
}

Result<std::string> plain_integer(std::string_view text, const NumberFormat& format) {
  auto number = plain_number(text, format);
  if (!number) return number;
  std::string& plain = number.value();
  const std::size_t point = std::min(plain.find('.'), plain.size());
  const std::string_view behind = std::string_view(plain).substr(point);
  // An integer needs no mark: "1.000" contains a thousands mark.
  constexpr std::size_t kPointAndThree = 4;
  const bool is_integer = plain.find('e') == std::string::npos && behind.size() != kPointAndThree &&
                          behind.find_first_not_of(".0") == std::string_view::npos;
  if (!is_integer) return Error{en::say("'{}' is not a whole number", printable(text)), "", ""};
  plain.resize(point);
  if (plain == "-0") plain = "0";
  return plain;
}

Result<double> parse_typed_number(std::string_view text, const NumberFormat& format) {
  // Fast path: files hold millions of numbers that programs wrote.
  if (format.mark == DecimalMark::kPoint)
    if (const auto value = value_of(text)) return *value;
  const auto plain = plain_number(text, format);
  if (!plain) return plain.error();
  return *value_of(*plain);
}

std::optional<Message> number_ambiguity(std::string_view text, const NumberFormat& format) {
  if (in_ascii(text).find_first_not_of("0123456789.,'_ +-") != std::string::npos)
    return std::nullopt;
  const auto value = parse_typed_number(text, format);
  if (value || value.error().what == not_a_number(text).what) return std::nullopt;
  return value.error().what;
}

std::string format_typed_number(double value, DecimalMark mark) {
  std::string text = fmt::format("{}", value);
  if (mark == DecimalMark::kComma) std::replace(text.begin(), text.end(), '.', ',');
  return text;
}

std::optional<Message> Quantity::refusal(double value) const {
  if (possible.holds(value)) return std::nullopt;
  return en::say("must be a number from {:g} to {:g} {}", possible.low, possible.high,
                 std::string(unit));
}

std::optional<Message> Quantity::warning(double value) const {
  if (auto refused = refusal(value)) return refused;
  if (plausible.holds(value)) return std::nullopt;
  const std::string unit_text(unit);
  const Message of = meaning();
  if (value > plausible.high)
    return en::say("{:g} {} is more than typical for {} ({:g} to {:g} {}): check the decimal mark",
                   value, unit_text, of, plausible.low, plausible.high, unit_text);
  return en::say("{:g} {} is less than typical for {} ({:g} to {:g} {}): check the decimal mark",
                 value, unit_text, of, plausible.low, plausible.high, unit_text);
}

}  // namespace alltact
