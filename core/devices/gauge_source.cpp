#include "core/devices/gauge_source.h"

#include "core/base/letters.h"
#include "core/base/message.h"
#include "core/base/typed_number.h"
#include "core/base/units.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include <poll.h>
#include <unistd.h>

namespace alltact {

double gauge_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::optional<Eigen::Vector3d> axis_named(std::string_view name) {
  const double sign = name.starts_with('-') ? -1 : 1;
  if (name.starts_with('-') || name.starts_with('+')) name.remove_prefix(1);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (name == std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1))
      return Eigen::Vector3d(sign * Eigen::Vector3d::Unit(axis));
  return std::nullopt;
}

Result<GaugeDirections> GaugeDirections::parse(const std::string& text) {
  const Error wrong{en::say("'{}' is not a direction", printable(text)), "",
                    en::say("x, -y, 0.6,0.8,0 or, for several values, x/y/z")};
  GaugeDirections directions;
  std::string_view rest = text;
  while (true) {
    const std::size_t end = std::min(rest.find('/'), rest.size());
    const std::string_view part = rest.substr(0, end);
    auto direction = axis_named(part);
    if (!direction) {
      const GaugeLine line = read_gauge_line(part, {});
      if (line.kind != GaugeLine::Kind::kValues || line.count != 3) return wrong;
      direction = Eigen::Vector3d(line.force_N[0], line.force_N[1], line.force_N[2]);
    }
    if (!(direction->norm() > 1e-9) || directions.count == 3) return wrong;
    directions.of[static_cast<std::size_t>(directions.count++)] = direction->normalized();
    if (end == rest.size()) return directions;
    rest.remove_prefix(end + 1);
  }
}

Eigen::Vector3d GaugeDirections::force_N(const GaugeLine& line) const {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(line.count); ++i)
    force += line.force_N[i] * of[i];
  return force;
}

GaugeSample sample_of(const GaugeLine& line, const GaugeDirections& directions, double time_s) {
  GaugeSample sample;
  sample.time_s = time_s;
  sample.has_force = true;
  sample.force_N = directions.force_N(line);
  double coarsest_N = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(line.count); ++i)
    coarsest_N = std::max(coarsest_N, line.digit_N[i]);
  if (coarsest_N > 0) sample.sd_N = coarsest_N / std::sqrt(12.0);
  return sample;
}

namespace {

constexpr double kMaxGaugeN = 1e5;

/// Over-range words that gauges send instead of a number; only letters and digits count.
bool is_over_range_word(std::string_view line) {
  static constexpr std::array<std::string_view, 16> kWords{
      "OL",    "0L", "OVER", "OVR", "OVL",   "OVERLOAD", "OVERRANGE", "OVERFLOW",
      "UNDER", "UL", "HELP", "ERR", "ERROR", "LOADOVER", "OLOAD",     "FULL"};
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
  const bool is_shared = std::none_of(units.begin(), units.end() - 1,
                                      [](const std::optional<double>& unit) { return unit; });
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!put(numbers[i], is_shared ? last_N : units[i].value_or(rules.unit_N), reading))
      return GaugeLine();
  reading.kind = GaugeLine::Kind::kValues;
  return reading;
}

}  // namespace

GaugeLine read_gauge_line(std::string_view line, const GaugeLineRules& rules) {
  const bool is_text = std::all_of(line.begin(), line.end(),
                                   [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; });
  if (!is_text || line.empty()) return {};
  if (is_over_range_word(line)) {
    GaugeLine over;
    over.kind = GaugeLine::Kind::kOverRange;
    return over;
  }
  return rules.format == GaugeFormat::kSauter ? sauter_line(line, rules.unit_N)
                                              : plain_line(line, rules);
}

std::optional<double> newtons_in(std::string_view unit) {
  const auto force = measurement_unit(Measure::kForce, unit);
  return force ? std::optional(force->convert(1)) : std::nullopt;
}

namespace {

/// Makes a name fit for a cell of a table.
std::string typed_name(std::string name) {
  for (char& c : name)
    if (c == ',' || c == '"' || static_cast<unsigned char>(c) < ' ') c = ' ';
  return std::string(trimmed(name));
}

/// The reason why a number in the line is ambiguous, as "1,200 N".
std::optional<Message> ambiguity_in(std::string_view line) {
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(" ;"), line.size());
    const std::string_view word = line.substr(0, end);
    const std::size_t digits = std::min(word.find_first_not_of("0123456789.,'_+-"), word.size());
    if (auto ambiguity = number_ambiguity(word.substr(0, digits))) return ambiguity;
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return std::nullopt;
}

}  // namespace

TypedGauge::TypedGauge(int descriptor, const GaugeLineRules& rules,
                       const GaugeDirections& directions)
    : descriptor_(descriptor), rules_(rules), directions_(directions) {
  rules_.is_comma_decimal = true;
}

Result<GaugeUpdate> TypedGauge::read(int timeout_ms) {
  GaugeUpdate update;
  update.is_over = is_over_;
  if (is_over_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(timeout_ms));
    return update;
  }
  pollfd waiting{descriptor_, POLLIN, 0};
  if (::poll(&waiting, 1, timeout_ms) <= 0) return update;
  std::array<char, 1024> bytes{};
  const ssize_t size = ::read(descriptor_, bytes.data(), bytes.size());
  if (size < 0 && (errno == EINTR || errno == EAGAIN)) return update;
  const double now_s = gauge_clock_s();
  if (size <= 0) {
    if (!unfinished_.empty()) take(std::exchange(unfinished_, {}), now_s, update);
    update.is_over = is_over_ = true;
    return update;
  }
  unfinished_.append(bytes.data(), static_cast<std::size_t>(size));
  for (std::size_t end = unfinished_.find('\n'); end != std::string::npos;
       end = unfinished_.find('\n')) {
    take(unfinished_.substr(0, end), now_s, update);
    unfinished_.erase(0, end + 1);
  }
  return update;
}

bool TypedGauge::take_name(const std::string& line, GaugeUpdate& update) {
  for (auto [word, name] : {std::pair{"block ", &block_}, {"indenter ", &indenter_}})
    if (line.starts_with(word)) {
      *name = typed_name(line.substr(std::string_view(word).size()));
      update.remarks.push_back(en::say("{} from now on", printable(line)));
      return true;
    }
  return false;
}

void TypedGauge::take(std::string line, double time_s, GaugeUpdate& update) {
  line = trimmed(line);
  time_s = last_s_ = std::max(time_s, last_s_ + 1e-6);
  GaugeSample sample;
  sample.time_s = time_s;
  if (line.empty()) {
    update.samples.push_back(sample);
    update.remarks.push_back(en::say("the typed value no longer applies"));
    return;
  }
  if (take_name(line, update)) return;
  std::string_view rest = line;
  const std::size_t blank = std::min(rest.find(' '), rest.size());
  GaugeDirections directions = directions_;
  if (const auto axis = axis_named(rest.substr(0, blank))) {
    directions.of[0] = *axis, directions.count = 1;
    rest.remove_prefix(std::min(blank + 1, rest.size()));
  }
  if (const auto ambiguity = ambiguity_in(rest)) {
    update.remarks.push_back(*ambiguity);
    return;
  }
  const GaugeLine reading = read_gauge_line(rest, rules_);
  if (reading.kind != GaugeLine::Kind::kValues || (directions.count == 1 && reading.count != 1)) {
    update.remarks.push_back(
        en::say("'{}' is not a reading; type a number, 'y 1.2 N', 'block NAME', or nothing",
                printable(line)));
    return;
  }
  directions_ = directions;
  sample = sample_of(reading, directions_, time_s);
  sample.holds = true;
  sample.block = block_.empty() ? fmt::format("typed {}", ++count_) : block_;
  sample.indenter = indenter_;
  update.remarks.push_back(en::say("{:.3f} {:.3f} {:.3f} N", sample.force_N.x(), sample.force_N.y(),
                                   sample.force_N.z()));
  update.samples.push_back(std::move(sample));
}

}  // namespace alltact
