// Which mapping to fit, and how much of each contact to believe: decided by the presses themselves.
#pragma once

#include "calibration/joint/calibration_settings.h"
#include "calibration/joint/joint_fit.h"
#include "calibration/joint/starting_curve.h"
#include "core/message.h"

#include <optional>
#include <vector>

namespace alltact {

struct ModelChoice {
  JointOptions options;             ///< along and zone
  JointFit fit;                     ///< of the chosen family, to go on from
  std::vector<double> held_out_mm;  ///< one a press; empty with one press
  double spread_mm = 0;             ///< see Calibration::spread_mm; 0 with one press
  Message sentence;                 ///< why
  std::vector<Message> remarks;
};

/// The mean absolute error inside a contact of a press that the mapping was fitted without, only
/// its ball being fitted to it, decides between families; among those within one standard error of
/// the best the simplest wins, Moebius before polynomials of two and more coefficients.
/// Contacts are read within 0.65 of their rim, where skin and ball touch on any material (Hertz:
/// 0.71); where chance leaves more than a hundredth of the depth open then, as far out as skin and
/// ball touch by the lift-off (lift_off.h) that all presses tell, and as what all show alike, ring
/// by ring, is explained. Along which thickness counts is told first, by the family of layers. With
/// five presses and more the mapping may vary over the face, when presses left out agree clearly
/// better then. nullopt when no family gave an increasing curve, or the job was stopped before one
/// had.
[[nodiscard]] std::optional<ModelChoice> choose_model(const ChoiceInput& input,
                                                      const CalibrationSettings& settings,
                                                      const Job& job);

}  // namespace alltact
