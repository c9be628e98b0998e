// Numbers as people type them: in a field of the window, behind a flag, in a file, in a table.
// The one parser of all of these.
#pragma once

#include "core/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// The decimal mark of a language. Files and flags use the point, in every language.
enum class DecimalMark { kPoint = 1, kComma };

struct NumberWriting {
  DecimalMark mark = DecimalMark::kPoint;
  std::string unit = {};  ///< may follow the number, for example "mm"; empty: none may
};

/// Both decimal marks are decimal: "4.5" and "4,5" are 4.5 in every language. Accepted too:
///   a sign, with the minus signs of typesetters ("−4.5"), an exponent ("1.5e-3"),
///   full-width digits, signs and marks of Chinese input methods ("４．５", "4，5", "4。5"),
///   blanks around the number, and the unit behind it ("4.5 mm").
/// Refused with a sentence:
///   thousands marks ("1.234,5", "1'000", "1 000"),
///   what may be one: three digits behind the mark that parts thousands in this language, where one
///   to three digits stand before it ("4.500" in German, "4,500" in English and in files),
///   another unit, and everything else, "nan", "inf" and "0x1f" among it.
/// The error's `where` and `advice` are empty: its one sentence says what to write instead.
[[nodiscard]] Result<double> parse_typed_number(std::string_view text,
                                                const NumberWriting& writing = {});

/// Of a text of digits and marks that can be read in two ways, or has marks between thousands, why
/// it is refused. nullopt: a number, or no number at all.
[[nodiscard]] std::optional<Message> doubt_of_number(std::string_view text,
                                                     const NumberWriting& writing = {});

/// The same number as std::from_chars reads it: "-4.5e3".
[[nodiscard]] Result<std::string> plain_number(std::string_view text,
                                               const NumberWriting& writing = {});

/// As plain_number(), of a whole number without exponent; "6.0" is "6".
[[nodiscard]] Result<std::string> plain_whole_number(std::string_view text,
                                                     const NumberWriting& writing = {});

/// Shortest text that parse_typed_number() reads as the same number.
[[nodiscard]] std::string format_typed_number(double value, DecimalMark mark = DecimalMark::kPoint);

}  // namespace alltact
