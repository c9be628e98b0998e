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
// Simulated calibrations with a known fault are examples, and test these rules.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/report/press_errors.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"

#include <cstdint>
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

// Simulated calibrations with a known fault: examples of each fault, and tests of the rules that
// detect it.

enum class Fault {
  kNone = 1,
  kBallRadius,         ///< given 10 % too large
  kMovedCamera,        ///< moved by a few pixels between reference and presses
  kAutomaticExposure,  ///< another gain in every press, within 6 %
  kOtherLight,         ///< 5 % more light than in the reference
  kLooseSkin,          ///< the skin leaves the ball early and bulges brightly around it
};

struct SimulatedCalibration {
  Calibration calibration;
  std::vector<PressResiduals> residuals;
  std::vector<PressSign> signs;
};

/// Four presses of a 4 mm ball on a small flat sensor (240 x 180 px, 0.1 mm a pixel), through the
/// same pipeline and calibration as real ones. correct_light: the pipeline's default; without it
/// the fault shows uncorrected. About 0.1 s. Errors: the job was stopped.
[[nodiscard]] Result<SimulatedCalibration> simulate_calibration(Fault fault, std::uint64_t seed,
                                                                bool correct_light, const Job& job);

}  // namespace alltact
