#include "core/base/utc_time.h"

#include "core/base/letters.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>

#include <fmt/chrono.h>

namespace alltact {
namespace {

std::string utc_in(std::chrono::seconds ahead) {
  const std::time_t then =
      std::chrono::system_clock::to_time_t(std::chrono::system_clock::now() + ahead);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(then));
}

}  // namespace

std::string utc_now() { return utc_in({}); }

// The format is fixed: alphabetical order is order in time.
std::string utc_not_before(const std::string& earliest) {
  const std::string now = utc_now();
  return is_utc(earliest) && earliest > now ? earliest : now;
}

bool is_ahead_of_clock(const std::string& date) {
  return is_utc(date) && date > utc_in(std::chrono::minutes(1));
}

bool is_utc(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  return text.size() == kForm.size() &&
         std::equal(text.begin(), text.end(), kForm.begin(),
                    [](char c, char form) { return form == '0' ? is_digit(c) : c == form; });
}

std::optional<double> unix_seconds(const std::string& time) {
  int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0, read = 0;
  if (std::sscanf(time.c_str(), "%4d-%2d-%2dT%2d:%2d:%2dZ%n", &year, &month, &day, &hour, &minute,
                  &second, &read) != 6 ||
      read != 20 || time.size() != 20)
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok() || hour > 23 || minute > 59 || second > 60) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return 86400.0 * static_cast<double>(days) + 3600.0 * hour + 60.0 * minute + second;
}

}  // namespace alltact
