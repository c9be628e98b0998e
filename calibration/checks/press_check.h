// Is a calibrated finger still what it was: a few presses of the ball, held against the mapping.
//
// The mapping stays as it is. Each ball is found from the shape of its contact alone: its centre
// and one factor on all depths are fitted, so that a ball cannot sink in to meet a mapping that
// reads too deep. The error of a press is then the mean of |M(x) - depth of that ball| in the inner
// part of the contact (kSureRim), in mm. What the light of the whole face has changed by is told by
// the untouched skin (light_gain.h), which also corrects it.
//
// The rule. The presses that the finger was calibrated with are measured in the same way; m and s
// are mean and standard deviation of their errors, l and k those of their change of light (without
// those presses m = 2 h, s = h, h the calibration's error on presses left out). With n new presses:
//   drifting     where their mean error exceeds m + 3 s / sqrt(n), which chance does once in some
//                hundred checks, or 0.02 mm (a third of what is still called good) if that is more;
//                or their mean light differs from l by more than 2 % or 3 k / sqrt(n), if that is
//                more;
//   recalibrate  where the error exceeds twice that limit and what is still called good (0.06 mm),
//                or the light differs by more than 6 %, or by three times its limit if that is
//                more: a tenth of what is taken out of the light may stay in the depth.
// A press counts only where the ball is found in it. Of a flat punch with a step (step_press.h) the
// error is what its step reads too high or too low.
#pragma once

#include "calibration/presses/press_input.h"
#include "calibration/verdict/press_coverage.h"
#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

struct CheckedPress {
  std::string name;
  double error_mm = 0;
  double factor = 1;        ///< true depth / depth read: above 1 the mapping reads too shallow
  double depth_mm = 0;      ///< deepest point of the ball; of a punch the height of its step
  double light_change = 0;  ///< 0.02: the face is 2 % brighter than its reference
  ContactSpot spot;         ///< where on the face
};

struct PressCheck {
  CheckVerdict verdict = CheckVerdict::kPass;
  double error_mm = 0;  ///< mean of the presses
  double drifting_above_mm = 0, recalibrate_above_mm = 0;
  double factor = 1;        ///< mean of the presses
  double light_change = 0;  ///< against the presses of the calibration
  double light_limit = 0;   ///< drifting above
  double ball_radius_mm = 0;
  std::vector<CheckedPress> presses;  ///< by name
  int positions = 0;                  ///< distinct ones on the face (PressCoverage)
  std::array<int, 3> thirds = {};     ///< of them in base, middle, tip (flat: left, ...)
  bool is_flat = false;
  std::vector<Message> left_out;            ///< "press_3: why"
  std::vector<std::string> left_out_names;  ///< "press_3"
  Message sentence;                         ///< verdict, figures and what to do
};

/// The same for any order of the presses; nothing is written.
///   said: of the presses: steps, and the ball where it is not that of the calibration
/// Errors: the finger has no mapping, or no radius is known; those of its reference and of pictures
/// that cannot be used; no ball in any press; stopped.
[[nodiscard]] Result<PressCheck> check_with_presses(const FingerSnapshot& snapshot,
                                                    const PressInput& presses,
                                                    const PressSet& said,
                                                    const Job& job);

/// What checks go by: light beyond the first is drifting, beyond the second no light to measure in;
/// no error below the third counts.
inline constexpr double kLightLimit = 0.02;  // lamps that are warm stay within
inline constexpr double kLightOff = 0.06;
inline constexpr double kLeastErrorMm = kGoodErrorMm / 3;

}  // namespace alltact
