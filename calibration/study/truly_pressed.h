// Which pixels of a truth count as what, wherever errors are told.
#pragma once

namespace alltact {

inline constexpr float kPressedMm = 0.05F;    ///< truly deeper: inside a contact
inline constexpr float kUntouchedMm = 0.01F;  ///< truly less: not contact
inline constexpr double kAwayMm = 1.0;        ///< distance from any contact that counts as away

}  // namespace alltact
