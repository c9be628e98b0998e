// Units of measurement as people and programs write them in files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace alltact {

/// What a unit measures, with the unit to which measurement_unit() converts.
enum class Measure {
  kNumber = 1,  ///< without a unit
  kTime,        ///< s
  kForce,       ///< N
  kLength,      ///< mm
  kTurn,        ///< turns
  kPixel,       ///< px
};

/// value in Measure's unit = value * up / down. Both are exact but for rad: 8190 ms is the double
/// nearest to 8.19 s.
struct MeasurementUnit {
  double up = 1, down = 1;
  std::string_view symbol = "";
  [[nodiscard]] double convert(double value) const { return value * up / down; }
};

/// The unit in upper or lower case: ns, us, ms, s, min, h, d; N, mN, kN, gf, kgf, lbf, ozf; um, mm,
/// cm, m, in; turn, deg, rad; px; and their names in full, such as "seconds" and "Sekunden".
/// A kilogram is its weight at the standard gravity of 9.80665 m/s^2 (3rd CGPM, 1901), a pound
/// 0.45359237 kg and an inch 25.4 mm (international yard and pound agreement, 1959), an ounce a
/// sixteenth of a pound. nullopt: no such unit of this measure; "MN", which may be meganewtons.
[[nodiscard]] std::optional<MeasurementUnit> measurement_unit(Measure measure,
                                                              std::string_view name);

/// "ns, us, ms, s, min, h, d"
[[nodiscard]] std::string measurement_units(Measure measure);

/// True for a unit of any measure.
[[nodiscard]] bool is_measurement_unit(std::string_view name);

}  // namespace alltact
