#include "core/base/time_stamp.h"

#include "core/base/letters.h"
#include "core/base/message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

namespace alltact {
namespace {

constexpr std::array<std::string_view, 12> kMonths{"jan", "feb", "mar", "apr", "may", "jun",
                                                   "jul", "aug", "sep", "oct", "nov", "dec"};

std::vector<std::string_view> parts_at(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = std::min(text.find(mark), text.size());
    parts.push_back(text.substr(0, end));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

/// One to `max_digits` digits.
std::optional<int> digits_of(std::string_view text, std::size_t max_digits) {
  int value = 0;
  if (text.empty() || text.size() > max_digits || !std::all_of(text.begin(), text.end(), is_digit))
    return std::nullopt;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::optional<int> month_of(std::string_view text) {
  const std::string name = lowered(std::string(text));
  const auto found = std::find(kMonths.begin(), kMonths.end(), name);
  if (found != kMonths.end()) return static_cast<int>(found - kMonths.begin()) + 1;
  return digits_of(text, 2);
}

std::optional<std::chrono::sys_days> date_from(int year, int month, int day) {
  if (month < 1 || day < 1) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  return date.ok() ? std::optional(std::chrono::sys_days(date)) : std::nullopt;
}

/// Reads a date into the stamp; false: none.
bool take_date(std::string_view text, TimeStamp& stamp) {
  const std::size_t mark = text.find_first_of("-/.");
  if (mark == std::string_view::npos) return false;
  const auto parts = parts_at(text, text[mark]);
  if (parts.size() != 3) return false;
  const auto month = month_of(parts[1]);
  if (!month) return false;
  if (parts[0].size() == 4) {
    const auto year = digits_of(parts[0], 4), day = digits_of(parts[2], 2);
    if (year && day) stamp.date = date_from(*year, *month, *day);
    return stamp.date.has_value();
  }
  const auto first = digits_of(parts[0], 2), year = digits_of(parts[2], 4);
  if (!first || !year || parts[2].size() != 4) return false;
  const auto day_first = date_from(*year, *month, *first);
  // Only dots and names of months stand for one order in all countries.
  const bool is_one_order = text[mark] == '.' || !is_digit(parts[1][0]);
  const auto month_first = is_one_order ? std::nullopt : date_from(*year, *first, *month);
  stamp.is_date_ambiguous = day_first && month_first && day_first != month_first;
  stamp.date = day_first ? day_first : month_first;
  return stamp.date.has_value();
}

/// Removes "Z", "+01:00", "+0100", "+01" from the end of a clock; false: a zone that does not
/// exist.
bool take_zone(std::string_view& clock, TimeStamp& stamp) {
  if (clock.ends_with('Z')) {
    stamp.ahead_of_s = 0;
    clock.remove_suffix(1);
    return true;
  }
  const std::size_t sign = clock.find_first_of("+-");
  if (sign == std::string_view::npos) return true;
  std::string digits;
  for (const char c : clock.substr(sign + 1))
    if (c != ':') digits += c;
  const auto hours = digits_of(std::string_view(digits).substr(0, 2), 2);
  const auto minutes =
      digits.size() == 2 ? 0 : digits_of(digits.size() == 4 ? digits.substr(2) : "", 2);
  if (!hours || !minutes || *hours > 14 || *minutes > 59) return false;
  stamp.ahead_of_s = (clock[sign] == '-' ? -60 : 60) * (60 * *hours + *minutes);
  clock = trimmed(clock.substr(0, sign), " ");
  return true;
}

/// Adds 12 hours behind "PM"; nullopt: an hour that such a clock does not have.
std::optional<int> take_half_day(std::string_view& clock, int hours) {
  const bool is_am = clock.ends_with("AM") || clock.ends_with("am");
  const bool is_pm = clock.ends_with("PM") || clock.ends_with("pm");
  if (!is_am && !is_pm) return hours;
  clock = trimmed(clock.substr(0, clock.size() - 2), " ");
  if (hours < 1 || hours > 12) return std::nullopt;
  return hours % 12 + (is_pm ? 12 : 0);
}

/// Digits with a fraction behind a point or comma, from 0 to below 60.
std::optional<double> seconds_of(std::string_view text) {
  const std::size_t mark = std::min(text.find_first_of(".,"), text.size());
  const std::string_view behind = text.substr(std::min(mark + 1, text.size()));
  const auto full = digits_of(text.substr(0, mark), 2);
  if (!full || *full > 59 || !std::all_of(behind.begin(), behind.end(), is_digit))
    return std::nullopt;
  if (mark < text.size() && behind.empty()) return std::nullopt;
  double seconds = 0;
  const std::string plain =
      std::to_string(*full) + (behind.empty() ? "" : ".") + std::string(behind);
  std::from_chars(plain.data(), plain.data() + plain.size(), seconds);
  return seconds;
}

bool take_clock(std::string_view clock, TimeStamp& stamp) {
  if (!take_zone(clock, stamp)) return false;
  const std::size_t colon = clock.find(':');
  if (colon == std::string_view::npos) return false;
  const auto first = digits_of(clock.substr(0, colon), stamp.date ? 2 : 4);
  if (!first) return false;
  const auto hours = take_half_day(clock, *first);
  const auto parts = parts_at(clock, ':');
  if (!hours || parts.size() < 2 || parts.size() > 3) return false;
  const bool has_hours = parts.size() == 3 || stamp.date;
  if (stamp.date && *hours > 23) return false;
  const auto minutes = has_hours ? digits_of(parts[1], 2) : first;
  const auto seconds = parts.size() == 3 ? seconds_of(parts[2])
                       : has_hours       ? std::optional(0.0)
                                         : seconds_of(parts[1]);
  if (!minutes || !seconds || (has_hours && *minutes > 59)) return false;
  stamp.clock_s = (has_hours ? 3600.0 * *hours : 0) + 60.0 * *minutes + *seconds;
  return true;
}

}  // namespace

double TimeStamp::seconds() const {
  const double days = date ? static_cast<double>(date->time_since_epoch().count()) : 0;
  return 86400 * days + clock_s.value_or(0) - ahead_of_s.value_or(0);
}

Result<TimeStamp> parse_time_stamp(std::string_view text) {
  text = trimmed(text, " ");
  const Error wrong{en::say("'{}' is not a date or time that exists", printable(text)), "", ""};
  TimeStamp stamp;
  const std::size_t colon = text.find(':');
  const std::size_t between =
      colon == std::string_view::npos ? text.size() : text.find_first_of(" T");
  if (between < text.size() && (colon == std::string_view::npos || between < colon)) {
    if (!take_date(text.substr(0, between), stamp)) return wrong;
    return take_clock(trimmed(text.substr(between + 1), " "), stamp) ? Result<TimeStamp>(stamp)
                                                                     : wrong;
  }
  if (colon == std::string_view::npos)
    return take_date(text, stamp) ? Result<TimeStamp>(stamp) : wrong;
  if (std::count(text.begin(), text.end(), ':') == 1 &&
      text.find_first_of(".,") == std::string_view::npos)
    return Error{en::say("'{}' can be hours and minutes, or minutes and seconds", printable(text)),
                 "", ""};
  return take_clock(text, stamp) ? Result<TimeStamp>(stamp) : wrong;
}

bool resembles_time_stamp(std::string_view text) {
  text = trimmed(text, " ");
  if (text.empty() || !is_digit(text.front())) return false;
  if (text.find_first_of(":/") != std::string_view::npos) return true;
  const auto has_two = [&](char mark) { return std::count(text.begin(), text.end(), mark) == 2; };
  return has_two('-') || (has_two('.') && text.size() <= 10);
}

}  // namespace alltact
