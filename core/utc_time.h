// Times in files.
#pragma once

#include <string>
#include <string_view>

namespace alltact {

/// Date and time in UTC as 2026-01-31T12:00:00Z.
[[nodiscard]] std::string utc_now();
/// Whether a text looks like that.
[[nodiscard]] bool is_utc(std::string_view text);

}  // namespace alltact
