// Checks a calibrated finger with a few presses of the ball against its mapping.
//
// The mapping stays unchanged. Each ball is found from the shape of its contact alone: its centre
// and one factor on all depths are fitted, so that a ball cannot sink in to meet a mapping that is
// too deep. The error of a press is then the mean of |M(x) - depth of that ball| in the inner zone
// of the contact (kInnerRim), in mm. The untouched skin shows the change of the light over the face
// (light_gain.h), which also corrects it.
//
// The rule. The presses of the calibration are measured in the same manner; m and s are mean and
// standard deviation of their errors, l and k those of their change of light. Without those presses
// m = 2 h, s = h, h the calibration's error on held-out presses. With n new presses:
//   drifting     where their mean error exceeds m + 3 s / sqrt(n), which chance does once in some
//                hundred checks, or 0.02 mm (a third of what is still called good) if that is more;
//                or their mean light differs from l by more than 2 % or 3 k / sqrt(n), if that is
//                more;
//   recalibrate  where the error exceeds twice that limit and what is still called good (0.06 mm),
//                or the light differs by more than 6 %, or by three times its limit if that is
//                more: a tenth of what is taken out of the light may stay in the depth.
// A press counts only where the ball is found in it. For a flat punch with a step (step_press.h)
// the error is that of its step's height; for another body of known shape (body_press.h) that of
// its deepest point.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/presses/press_input.h"
#include "calibration/verdict/verdict.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/finger/mapping.h"

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct CheckedPress {
  std::string name;
  double error_mm = 0;
  double factor = 1;        ///< true depth / depth read: above 1 the mapping is too shallow
  double depth_mm = 0;      ///< deepest point of the body; of a punch the height of its step
  double light_change = 0;  ///< 0.02: the face is 2 % brighter than its reference
  ContactSpot spot;         ///< position on the face

  /// Depth read minus depth_mm.
  [[nodiscard]] double bias_mm() const { return depth_mm / factor - depth_mm; }
};

struct PressCheck {
  CheckVerdict verdict = CheckVerdict::kPass;
  double error_mm = 0;  ///< mean of the presses
  double drifting_above_mm = 0, recalibrate_above_mm = 0;
  double factor = 1;        ///< mean of the presses
  double bias_mm = 0;       ///< mean of the presses
  double light_change = 0;  ///< against the presses of the calibration
  double light_limit = 0;   ///< limit for drifting
  double ball_radius_mm = 0;
  std::vector<CheckedPress> presses;  ///< by name
  int positions = 0;                  ///< distinct ones on the face (PressCoverage)
  std::array<int, 3> thirds = {};     ///< of them in base, middle, tip (flat: left, ...)
  bool is_flat = false;
  std::vector<Message> left_out;            ///< "press_3: why"
  std::vector<std::string> left_out_names;  ///< "press_3", in name order
  Message sentence;                         ///< verdict, figures and what to do
};

/// The order of the presses does not matter; nothing is written.
///   press_notes: of the presses: steps, and the ball where it differs from the calibration's
/// Errors: the finger has no mapping, or no radius is known; those of its reference and of unusable
/// images; no ball in any press; stopped.
[[nodiscard]] Result<PressCheck> check_with_presses(const FingerSnapshot& snapshot,
                                                    const PressInput& presses,
                                                    const PressSet& press_notes, const Job& job);

/// Limits of checks: light beyond the first is drifting, beyond the second unusable; errors below
/// the third do not count.
inline constexpr double kLightLimit = 0.02;  // lamps that are warm stay within
inline constexpr double kLightOff = 0.06;
inline constexpr double kMinErrorMm = kGoodErrorMm / 3;

// Estimates the ball of one press from the shape of its contact, and the mapping's errors there.

struct BallByShape {
  Eigen::Vector3d centre_mm;                             ///< camera frame
  double factor = 1;                                     ///< true depth / depth read
  double depth_mm = 0;                                   ///< of its deepest point
  Eigen::Vector2d on_face_mm = Eigen::Vector2d::Zero();  ///< of its contact, along and across
  /// Mapping minus ball, mm, of the samples in the inner zone of the contact (kInnerRim); never
  /// empty.
  std::vector<double> errors_mm;
};

/// Fits the centre and one factor on all depths, so that the ball cannot sink in to meet a mapping
/// that is too deep. The errors are those of the mapping without that factor. Errors: those of
/// find_ball(); a contact of too few pixels; no ball fits; stopped.
[[nodiscard]] Result<BallByShape> ball_by_shape(const Press& press, const Face& face,
                                                const Mapping& mapping, const Job& job);

}  // namespace alltact
