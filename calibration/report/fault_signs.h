// Faults of a calibration that its own pictures give away.
//
// Light. The untouched skin of every press tells by how much the face is brighter than its
// reference (light_gain.h). Presses that all differ alike were taken in another light; presses that
// differ among each other were taken with an exposure or gain that is not locked, or beside a light
// that changes. Pose. A bending finger is compared with a reference of its own pose; where the
// recording holds none the reference is a guess: now and then a press
// just beyond the recording does no harm, most of them do.
//
// What no picture of a calibration gives away is a wrong radius of the ball: a cap is nearly a
// paraboloid, depth = D - r^2 / (2 R), so that with a radius 10 % too large every depth comes out
// 10 % too small and the presses agree as well as ever. A check with a ball of another size shows
// it (press_check.h).
#pragma once

#include "core/message.h"

#include <vector>

namespace alltact {

/// What a press tells beside its contact.
struct PressSign {
  double light_change = 0;  ///< 0.02: the face is 2 % brighter than its reference
  bool known_pose = true;   ///< the reference recording holds the finger's pose
};

inline constexpr double kOtherLight = 0.02;     ///< mean of all presses
inline constexpr double kUnsteadyLight = 0.01;  ///< standard deviation of three presses and more

/// A sentence without full stop for each sign, most serious first; empty where there is none.
[[nodiscard]] std::vector<Message> fault_signs(const std::vector<PressSign>& presses);

}  // namespace alltact
