#include "core/utc_time.h"

#include <algorithm>
#include <chrono>
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

std::string utc_now() {
  return utc_in({});
}

// Dates in one format: their order as text is their order in time.
std::string utc_now_from(const std::string& earliest) {
  const std::string now = utc_now();
  return is_utc(earliest) && earliest > now ? earliest : now;
}

bool is_ahead_of_clock(const std::string& date) {
  return is_utc(date) && date > utc_in(std::chrono::minutes(1));
}

bool is_utc(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  return text.size() == kForm.size() &&
         std::equal(text.begin(), text.end(), kForm.begin(), [](char c, char form) {
           return form == '0' ? c >= '0' && c <= '9' : c == form;
         });
}

}  // namespace alltact
