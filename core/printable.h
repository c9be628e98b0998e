// Foreign text made safe for messages.
#pragma once

#include <string>
#include <string_view>

namespace alltact {

/// Maximum number of a value's characters that a message repeats.
inline constexpr std::size_t kMaxPrinted = 60;

/// Returns the text on one line. Control characters and bytes that are not UTF-8 become
/// , \t or \x1b, so that no file controls a terminal. A text above kMaxPrinted characters is cut
/// and ends in "...".
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace alltact
