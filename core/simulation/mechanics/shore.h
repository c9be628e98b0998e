// Stiffness of a rubber from its durometer reading.
#pragma once

#include "core/result.h"

namespace alltact {

/// Durometer readings within the relation's range.
inline constexpr double kSoftestShoreA = 1, kHardestShoreA = 90;

/// Young's modulus in MPa (N/mm^2) of a rubber of hardness Shore A:
///   E = 0.0981 (56 + 7.66 S) / (0.137505 (254 - 2.54 S))
/// (A. N. Gent, "On the relation between indentation hardness and Young's modulus", Rubber
/// Chemistry and Technology 31, 1958, with the durometer's spring and pin put in). 40 gives 1.70,
/// 5 gives 0.28. Real castings differ by a tenth or more. Error: outside the readings above.
[[nodiscard]] Result<double> modulus_from_shore_a(double shore_a);

/// Of an incompressible rubber: E / 3.
[[nodiscard]] constexpr double shear_modulus(double modulus_MPa) {
  return modulus_MPa / 3;
}

}  // namespace alltact
