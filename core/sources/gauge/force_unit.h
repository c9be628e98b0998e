// Units of force that gauges use.
#pragma once

#include <optional>
#include <string_view>

namespace alltact {

/// Newtons in one N, mN, kN, g, gf, kg, kgf, lb, lbf, oz, ozf, in upper or lower case (gauges write
/// "lbF" and "KN"). A kilogram is its weight at the standard gravity of 9.80665 m/s^2 (3rd CGPM,
/// 1901), a pound 0.45359237 kg (international yard and pound agreement, 1959), an ounce a
/// sixteenth of that. nullopt: no unit of force.
[[nodiscard]] std::optional<double> newtons_in(std::string_view unit);

}  // namespace alltact
