// Thresholds on the ground truth, shared by all error figures.
#pragma once

namespace alltact {

inline constexpr float kPressedMm = 0.05F;    ///< deeper: inside a contact
inline constexpr float kUntouchedMm = 0.01F;  ///< less: no contact
inline constexpr double kAwayMm = 1.0;        ///< distance from any contact that counts as far

}  // namespace alltact
