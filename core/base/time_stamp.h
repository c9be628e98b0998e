// Dates and times of day as measuring programs and spreadsheets write them.
#pragma once

#include "core/base/result.h"

#include <chrono>
#include <optional>
#include <string_view>

namespace alltact {

/// A time stamp. At least one of date and clock is known.
struct TimeStamp {
  std::optional<std::chrono::sys_days> date;
  std::optional<double> clock_s;   ///< since midnight, or since the start of a measurement
  std::optional<int> ahead_of_s;   ///< of UTC, where the text has a time zone
  bool is_date_ambiguous = false;  ///< 03/04/2026: `date` has the day first

  /// Seconds since 1970-01-01, or since midnight without a date. Without a zone: as if in UTC.
  [[nodiscard]] double seconds() const;
};

/// Parses, with a date, a clock, or both with a blank or "T" between them:
///   2026-03-01, 2026/03/01, 01.03.2026, 01-Mar-2026; 03/01/2026, where a part above 12 is the day
///   12:00:00, 12:00:00.123, 12:00:00,123, 1:02:03 PM; 01:23.4 (minutes, seconds); with a date
///   12:00; and behind it Z, +01:00, +0100 or +01
/// Errors, with an empty `where`: a date or time of day that does not exist; "12:30" without a
/// date, which may be hours or minutes; anything else.
[[nodiscard]] Result<TimeStamp> parse_time_stamp(std::string_view text);

/// True for a text that resembles a time stamp more than a number: digits around ':' or '/', or
/// around two '-' or '.'.
[[nodiscard]] bool resembles_time_stamp(std::string_view text);

}  // namespace alltact
