// The one parser of numbers that people type: in fields of the window, flags, files and tables.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

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

// Physical quantities that people type: unit, possible and plausible range, each declared once.
// Flags, fields of the window, files and tables check against these.

/// Both ranges are inclusive. A value outside `possible` is refused, one outside `plausible` is
/// accepted with a warning: often its decimal mark is at the wrong position, or its unit is another
/// one.
struct Quantity {
  struct Range {
    double low, high;
    [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }
  };
  std::string_view key;  ///< in files and flags: "layer_mm"
  std::string_view unit;
  Range possible;
  Range plausible;
  Message (*meaning)();  ///< "the thickness of the layer"

  /// "must be a number from 0.05 to 20 mm"; nullopt: possible. NaN is impossible.
  [[nodiscard]] std::optional<Message> refusal(double value) const;
  /// The warning for an implausible value, with the plausible range; nullopt: plausible. For an
  /// impossible value, the refusal.
  [[nodiscard]] std::optional<Message> warning(double value) const;
};

/// Sources of the plausible ranges: balls, layers and fingers of vision-based tactile sensors that
/// are published or sold (GelSight, DIGIT, 9DTact, DelTact, Fin Ray grippers), twice as wide on
/// either side. The possible ranges end where optics or a hand in a laboratory end.
inline constexpr Quantity kBallRadius{
    "ball_radius_mm", "mm", {0.1, 100}, {0.5, 20}, [] { return en::say("the radius of a ball"); }};
inline constexpr Quantity kFaceWidth{
    "width_mm", "mm", {0.5, 500}, {5, 120}, [] { return en::say("the width of a face"); }};
inline constexpr Quantity kLayerThickness{
    "layer_mm", "mm", {0.01, 50}, {0.3, 5}, [] { return en::say("the thickness of a layer"); }};
inline constexpr Quantity kPlaneDistance{"plane_z_mm", "mm", {0.001, 10000}, {2, 500}, [] {
                                           return en::say("the distance of a flat face");
                                         }};
inline constexpr Quantity kPressDepth{
    "depth_mm", "mm", {1e-4, 50}, {0.02, 5}, [] { return en::say("the depth of a press"); }};
inline constexpr Quantity kDepthSd{"depth_sd_mm", "mm", {1e-4, 50}, {1e-4, 0.3}, [] {
                                     return en::say("the uncertainty of a depth");
                                   }};
inline constexpr Quantity kStepHeight{
    "step_mm", "mm", {1e-4, 50}, {0.02, 5}, [] { return en::say("the step of a punch"); }};
inline constexpr Quantity kBoardSquare{
    "square_mm", "mm", {0.01, 1000}, {0.5, 50}, [] { return en::say("the side of a square"); }};
inline constexpr Quantity kKnownLength{"known_length_mm", "mm", {0.001, 1000}, {1, 200}, [] {
                                         return en::say("a length on a finger");
                                       }};

}  // namespace alltact
