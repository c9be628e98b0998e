// A short text inside a PNG file.
#pragma once

#include <string>
#include <string_view>

namespace alltact {

/// A complete PNG file with `note` (UTF-8) as an iTXt chunk behind its header (PNG, third edition,
/// 11.3.3.4).
[[nodiscard]] std::string with_note(std::string_view png, std::string_view note);

/// The note of such a file; empty where it has none, or is no complete PNG.
[[nodiscard]] std::string note_of(std::string_view png);

}  // namespace alltact
