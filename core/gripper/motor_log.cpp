#include "core/gripper/motor_log.h"

#include "core/io/atomic_file.h"
#include "core/printable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr std::string_view kMotorHeader = "time_ns,turns";

template <class T>
std::optional<T> parse_full(std::string_view text) {
  T value{};
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::pair<std::int64_t, double>> motor_line(std::string_view line) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto time = parse_full<std::int64_t>(line.substr(0, comma));
  const auto turns = parse_full<double>(line.substr(comma + 1));
  if (!time || !turns || !std::isfinite(*turns)) return std::nullopt;
  return std::pair(*time, *turns);
}

}  // namespace

Result<MotorLog> MotorLog::load(const std::filesystem::path& file) {
  const auto content = read_file(file);
  if (!content) return content.error();
  return parse(*content, file);
}

Result<MotorLog> MotorLog::parse(const std::string& content, const std::filesystem::path& origin) {
  MotorLog log;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find('\n', begin), content.size());
    std::string_view line = std::string_view(content).substr(begin, end - begin);
    begin = end + 1, ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);
    const auto refused = [&](Message what, Message advice) {
      return Error{what, fmt::format("{}:{}", origin.string(), number), advice};
    };
    if (number == 1) {
      if (line == kMotorHeader) continue;
      return refused(en::say("must be '{}', not '{}'", std::string(kMotorHeader), printable(line)),
                     en::say("a table of motor positions by time"));
    }
    if (line.empty() && begin >= content.size()) break;
    const auto read = motor_line(line);
    if (!read)
      return refused(
          en::say("must be a time in ns and a number of turns, not '{}'", printable(line)),
          en::say("for example 123456789,4.25"));
    if (!log.lines_.empty() && read->first <= log.lines_.back().first)
      return refused(en::say("the time is not after that of the line before"),
                     en::say("lines in the order of time"));
    log.lines_.push_back(*read);
  }
  if (log.lines_.size() < 2)
    return Error{en::say("holds fewer than two motor positions"),
                 origin,
                 en::say("a line for each time at which the motor was read")};
  return log;
}

std::optional<double> MotorLog::turns_at(std::int64_t time_ns) const {
  if (time_ns < lines_.front().first || time_ns > lines_.back().first) return std::nullopt;
  const auto after = std::lower_bound(
      lines_.begin(), lines_.end(), time_ns, [](const auto& line, std::int64_t time) {
        return line.first < time;
      });
  if (after->first == time_ns) return after->second;
  const auto& [time, turns] = *(after - 1);
  // In double, so that no difference overflows.
  const double part = (static_cast<double>(time_ns) - static_cast<double>(time)) /
                      (static_cast<double>(after->first) - static_cast<double>(time));
  return turns + std::clamp(part, 0.0, 1.0) * (after->second - turns);
}

}  // namespace alltact
