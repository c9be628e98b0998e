// The one parser of numbers that people type: in fields of the window, flags, files and tables.
#pragma once

#include "core/result.h"

#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// The decimal mark of a language. Files and flags use the point, in every language.
enum class DecimalMark { kPoint = 1, kComma };

struct NumberFormat {
  DecimalMark mark = DecimalMark::kPoint;
  std::string unit = {};  ///< may follow the number, for example "mm"; empty: no unit is accepted
};

/// Both decimal marks are decimal: "4.5" and "4,5" are 4.5 in every language. Accepted too:
///   a sign, with the minus signs of typesetters ("−4.5"), an exponent ("1.5e-3"),
///   full-width digits, signs and marks of Chinese input methods ("４．５", "4，5", "4。5"),
///   blanks around the number, and the unit behind it ("4.5 mm").
/// Refused with a sentence:
///   thousands marks ("1.234,5", "1'000", "1 000"),
///   a possible thousands mark: three digits behind the thousands mark of this language, with
///   one to three digits before it ("4.500" in German, "4,500" in English and in files),
///   another unit, and everything else, including "nan", "inf" and "0x1f".
/// The error's `where` and `advice` are empty: its one sentence contains the advice.
[[nodiscard]] Result<double> parse_typed_number(std::string_view text,
                                                const NumberFormat& format = {});

/// The reason why an ambiguous number, or one with thousands marks, is refused. nullopt: a valid
/// number, or no number at all.
[[nodiscard]] std::optional<Message> number_ambiguity(std::string_view text,
                                                      const NumberFormat& format = {});

/// Returns the number as std::from_chars reads it: "-4.5e3".
[[nodiscard]] Result<std::string> plain_number(std::string_view text,
                                               const NumberFormat& format = {});

/// As plain_number(), for an integer without exponent; "6.0" becomes "6".
[[nodiscard]] Result<std::string> plain_integer(std::string_view text,
                                                const NumberFormat& format = {});

/// The shortest text that parse_typed_number() reads as the same number.
[[nodiscard]] std::string format_typed_number(double value, DecimalMark mark = DecimalMark::kPoint);

}  // namespace alltact
