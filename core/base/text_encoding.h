// Texts of other programs in UTF-8.
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace alltact {

inline constexpr const char* kWesternEncoding = "Windows-1252";

struct DecodedText {
  std::string encoding;                  ///< "UTF-16" or kWesternEncoding; empty: UTF-8
  std::size_t mark_size = 0;             ///< bytes of the byte order mark in front of the text
  std::optional<std::string> converted;  ///< the text in UTF-8; empty: the bytes behind the mark
};

/// Finds the encoding of a text: UTF-8, or UTF-16 in either byte order, with or without a byte
/// order mark; else Windows-1252, which contains Latin-1. Errors: a workbook or a PDF; a character
/// that is cut off at the end; zero bytes.
[[nodiscard]] Result<DecodedText> decode_text(std::string_view bytes,
                                              const std::filesystem::path& origin);

/// Converts a text from the encoding of Chinese spreadsheet programs, which contains GBK and
/// GB2312. nullopt: it is in another one. Western texts can be valid, too.
[[nodiscard]] std::optional<std::string> from_gb18030(std::string_view bytes);

}  // namespace alltact
