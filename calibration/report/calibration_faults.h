// Faults of a calibration that its own images show.
//
// Light. The untouched skin of every press shows how much brighter the face is than its reference
// (light_gain.h). Presses that all differ alike were taken in another light. Presses that differ
// among each other were taken with an exposure or gain that is not locked, or near a changing
// light. Pose. A bending finger is compared with a reference of its own pose. Where the recording
// has none the reference is extrapolated. A few presses just beyond the recording are harmless, a
// majority is not.
//
// No image of a calibration shows a wrong radius of the ball. A cap is nearly a paraboloid, depth =
// D - r^2 / (2 R), so with a radius 10 % too large every depth comes out 10 % too small and the
// presses agree as before. A check with a ball of another size shows it (press_check.h).
//
// Simulated calibrations with a known fault test these rules (tests/support/simulated_fault.h).
#pragma once

#include "core/base/message.h"

#include <vector>

namespace alltact {

/// Evidence of one press outside its contact.
struct PressSign {
  double light_change = 0;  ///< 0.02: the face is 2 % brighter than its reference
  bool known_pose = true;   ///< the reference recording holds the finger's pose
};

inline constexpr double kOtherLight = 0.02;     ///< mean of all presses
inline constexpr double kUnsteadyLight = 0.01;  ///< standard deviation of three presses and more

/// A sentence without full stop for each fault, most serious first; empty where there is none.
[[nodiscard]] std::vector<Message> fault_signs(const std::vector<PressSign>& presses);

}  // namespace alltact
