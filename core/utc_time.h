// Times in files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// Date and time in UTC as 2026-01-31T12:00:00Z.
[[nodiscard]] std::string utc_now();
/// The same, or `earliest` where that is later: what is made from something is not older than it,
/// whatever the computer's clock says.
[[nodiscard]] std::string utc_now_from(const std::string& earliest);
/// A date that this computer's clock has yet to reach, by more than the minute by which clocks of a
/// lab differ. False for what is no such date.
[[nodiscard]] bool is_ahead_of_clock(const std::string& date);
/// Whether a text looks like that.
[[nodiscard]] bool is_utc(std::string_view text);
/// Seconds since 1970 of such a time; nullopt for anything else.
[[nodiscard]] std::optional<double> seconds_of(const std::string& time);

}  // namespace alltact
