// What somebody else wrote, made fit for a message: the one place that does it.
#pragma once

#include <string>
#include <string_view>

namespace alltact {

/// Most characters of a value that a message repeats.
inline constexpr std::size_t kMostPrinted = 60;

/// The text on one line: control characters and bytes that are no UTF-8 as \n, \t or \x1b, so that
/// no file writes on a terminal; longer than kMostPrinted characters it is cut there, "..." in
/// place of its end.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace alltact
