// Parser for one line of text from a gauge.
#pragma once

#include "core/result.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace alltact {

enum class GaugeFormat {
  /// Numbers with or without units: "+0.123 N", "-18.78 lbF" (Mark-10), "1.2 0.3 -0.1",
  /// "0.5,0.25"; and Imada's "+01.23KT0" or "+12.34NTO": unit O (lbf), K (kgf) or N, mode T or P,
  /// judgement, of which E is over range.
  kPlain = 1,
  /// "0011.70": for Sauter's FH and FL the first digit is the sign, 0 minus and 1 plus.
  kSauter,
};
inline constexpr std::array<std::string_view, 2> kGaugeFormats{"plain", "sauter"};

struct GaugeLineRules {
  GaugeFormat format = GaugeFormat::kPlain;
  double unit_N = 1;              ///< newtons per unit of a line without a unit
  bool is_comma_decimal = false;  ///< "1,25" is one number; else a comma separates two
};

struct GaugeLine {
  enum class Kind {
    kValues = 1,
    kOverRange,  ///< the gauge reports that it is out of range: OL, OVER, HELP, ----
    kNoise,      ///< neither: a broken line, a greeting, an error code
  };
  Kind kind = Kind::kNoise;
  int count = 0;                    ///< 1 to 3 values
  std::array<double, 3> force_N{};  ///< finite, at most 1e5 N
  std::array<double, 3> digit_N{};  ///< value of the last digit
  std::array<int, 3> decimals{};    ///< digits behind the point
};

/// Parses a line without its end. Each value is a complete number of the line: "0.12+0.123" and
/// "1.2.3" give none.
[[nodiscard]] GaugeLine read_gauge_line(std::string_view line, const GaugeLineRules& rules);

}  // namespace alltact
