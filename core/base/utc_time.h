// Times in files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// Date and time in UTC as 2026-01-31T12:00:00Z.
[[nodiscard]] std::string utc_now();
/// Returns utc_now(), or `earliest` where that is later. A derived file is never older than its
/// origin, whatever the computer's clock shows.
[[nodiscard]] std::string utc_not_before(const std::string& earliest);
/// True for a date more than a minute ahead of this computer's clock (the tolerance for clocks of a
/// lab). False for invalid dates.
[[nodiscard]] bool is_ahead_of_clock(const std::string& date);
/// True for a text of the format of utc_now().
[[nodiscard]] bool is_utc(std::string_view text);
/// Seconds since 1970 of such a time; nullopt for anything else.
[[nodiscard]] std::optional<double> unix_seconds(const std::string& time);

}  // namespace alltact
