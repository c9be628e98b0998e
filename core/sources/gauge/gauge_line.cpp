#include "core/sources/gauge/gauge_line.h"

#include "core/sources/gauge/force_unit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace alltact {
namespace {

constexpr double kMaxGaugeN = 1e5;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Over-range words that gauges send instead of a number; only letters and digits count.
bool is_over_range_word(std::string_view line) {
  static constexpr std::array<std::string_view, 16> kWords{"OL",
                                                           "0L",
                                                           "OVER",
                                                           "OVR",
                                                           "OVL",
                                                           "OVERLOAD",
                                                           "OVERRANGE",
                                                           "OVERFLOW",
                                                           "UNDER",
                                                           "UL",
                                                           "HELP",
                                                           "ERR",
                                                           "ERROR",
                                                           "LOADOVER",
                                                           "OLOAD",
                                                           "FULL"};
  std::string letters;
  bool is_rule = line.size() >= 3;
  for (const char c : line) {
    if (is_digit(c) || is_letter(c))
      letters += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    is_rule = is_rule && (c == '-' || c == '+' || c == '*' || c == '_' || c == '=' || c == '.' ||
                          c == '>' || c == '<' || c == ' ');
  }
  for (const std::string_view unit : {"KGF", "LBF", "KG", "LB", "KN", "N"})
    if (letters.size() > unit.size() && letters.ends_with(unit)) {
      const std::string bare = letters.substr(0, letters.size() - unit.size());
      if (std::find(kWords.begin(), kWords.end(), bare) != kWords.end()) return true;
    }
  return is_rule || std::find(kWords.begin(), kWords.end(), letters) != kWords.end();
}

/// Blanks and semicolons separate words, and so do commas that are not decimal.
std::vector<std::string> words_of(std::string_view line, bool is_comma_decimal) {
  std::vector<std::string> words;
  bool is_new = true;
  for (const char c : line) {
    const bool is_between = c == ' ' || c == '\t' || c == ';' || (c == ',' && !is_comma_decimal);
    if (!is_between && is_new) words.emplace_back();
    if (!is_between) words.back() += c == ',' ? '.' : c;
    is_new = is_between;
  }
  return words;
}

struct GaugeNumber {
  double value = 0;
  int decimals = 0;
};

/// Removes the number, with an optional sign, from the word's beginning and returns it.
std::optional<GaugeNumber> take_gauge_number(std::string_view& word) {
  std::string_view rest = word;
  const bool is_negative = rest.starts_with('-');
  if (is_negative || rest.starts_with('+')) rest.remove_prefix(1);
  std::size_t end = 0, point = std::string_view::npos, digits = 0;
  for (; end < rest.size() && (is_digit(rest[end]) || rest[end] == '.'); ++end) {
    if (rest[end] != '.')
      ++digits;
    else if (point != std::string_view::npos)
      return std::nullopt;
    else
      point = end;
  }
  if (digits == 0 || digits > 15) return std::nullopt;
  GaugeNumber number;
  std::from_chars(rest.data(), rest.data() + end, number.value, std::chars_format::fixed);
  if (is_negative) number.value = -number.value;
  if (point != std::string_view::npos) number.decimals = static_cast<int>(end - point - 1);
  rest.remove_prefix(end);
  word = rest;
  return number;
}

/// False: above the maximum force.
bool put(const GaugeNumber& number, double unit_N, GaugeLine& line) {
  const auto at = static_cast<std::size_t>(line.count++);
  line.force_N[at] = number.value * unit_N;
  line.decimals[at] = number.decimals;
  line.digit_N[at] = std::pow(10.0, -number.decimals) * unit_N;
  return std::abs(line.force_N[at]) <= kMaxGaugeN;
}

/// The unit behind an Imada gauge's number: "KTO", "NT0" and so on; nullopt for anything else.
std::optional<double> imada_unit_N(std::string_view tail) {
  if (tail.size() != 3 || (tail[1] != 'T' && tail[1] != 'P') ||
      std::string_view("LOHE0").find(tail[2]) == std::string_view::npos)
    return std::nullopt;
  switch (tail[0]) {
    case 'N':
      return newtons_in("N");
    case 'K':
      return newtons_in("kgf");
    case 'O':
      return newtons_in("lbf");
    default:
      return std::nullopt;
  }
}

GaugeLine sauter_line(std::string_view line, double unit_N) {
  GaugeLine reading;
  while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
  if (line.size() < 3 || (line[0] != '0' && line[0] != '1')) return reading;
  const bool is_plus = line[0] == '1';
  line.remove_prefix(1);
  if (!is_digit(line[0]) && line[0] != '.') return reading;
  auto number = take_gauge_number(line);
  if (!number || !line.empty()) return reading;
  if (!is_plus && number->value != 0) number->value = -number->value;
  if (!put(*number, unit_N, reading)) return {};
  reading.kind = GaugeLine::Kind::kValues;
  return reading;
}

GaugeLine plain_line(std::string_view line, const GaugeLineRules& rules) {
  GaugeLine reading;
  std::vector<std::optional<double>> units;  // of each number
  std::vector<GaugeNumber> numbers;
  for (const std::string& text : words_of(line, rules.is_comma_decimal)) {
    std::string_view word = text;
    if (const auto number = take_gauge_number(word)) {
      if (const auto imada = imada_unit_N(word)) {
        if (word[2] == 'E') return reading.kind = GaugeLine::Kind::kOverRange, reading;
        units.push_back(imada), numbers.push_back(*number);
        continue;
      }
      units.push_back(std::nullopt), numbers.push_back(*number);
      if (word.empty()) continue;
    }
    // A unit belongs to the number before it, and only to one that has none.
    const auto unit = newtons_in(word);
    if (!unit || units.empty() || units.back()) return reading;
    units.back() = unit;
  }
  if (numbers.empty() || numbers.size() > 3) return reading;
  // One unit behind several numbers belongs to all of them: "1.2 0.3 -0.1 kgf".
  const double last_N = units.back().value_or(rules.unit_N);
  const bool is_shared = std::none_of(
      units.begin(), units.end() - 1, [](const std::optional<double>& unit) { return unit; });
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!put(numbers[i], is_shared ? last_N : units[i].value_or(rules.unit_N), reading))
      return GaugeLine();
  reading.kind = GaugeLine::Kind::kValues;
  return reading;
}

}  // namespace

GaugeLine read_gauge_line(std::string_view line, const GaugeLineRules& rules) {
  const bool is_text = std::all_of(
      line.begin(), line.end(), [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; });
  if (!is_text || line.empty()) return {};
  if (is_over_range_word(line)) {
    GaugeLine over;
    over.kind = GaugeLine::Kind::kOverRange;
    return over;
  }
  return rules.format == GaugeFormat::kSauter ? sauter_line(line, rules.unit_N)
                                              : plain_line(line, rules);
}

}  // namespace alltact
