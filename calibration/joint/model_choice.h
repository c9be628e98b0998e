// Chooses the mapping's family and the zone of the contacts by the presses themselves.
#pragma once

#include "calibration/joint/calibration_settings.h"
#include "calibration/joint/joint_fit.h"
#include "calibration/joint/starting_curve.h"
#include "core/message.h"

#include <optional>
#include <vector>

namespace alltact {

struct ModelChoice {
  JointOptions options;             ///< `along` and `zone`
  JointFit fit;                     ///< of the chosen family, as a start
  std::vector<double> held_out_mm;  ///< one for each press; empty with one press
  double spread_mm = 0;             ///< see Calibration::spread_mm; 0 with one press
  Message sentence;                 ///< the reason
  std::vector<Message> remarks;
};

/// Families are compared by their mean absolute error inside the contact of a held-out press, to
/// which only the ball is fitted. Among those within one standard error of the best the simplest
/// wins, Moebius before polynomials of two and more coefficients.
///
/// Contacts are read within 0.65 of their rim, where skin and ball touch on any material (Hertz:
/// 0.71). Where chance leaves more than a hundredth of the depth open then, the zone is wider. It
/// reaches as far out as skin and ball touch by the lift-off (lift_off.h) that all presses
/// determine, and as the common residuals of the rings are explained. The direction of the
/// thickness is chosen first, by the family of layers. With five presses and more the mapping may
/// vary over the face, when held-out presses agree clearly better then. nullopt when no family gave
/// an increasing curve, or the job was stopped before one had.
[[nodiscard]] std::optional<ModelChoice> choose_model(const ChoiceInput& input,
                                                      const CalibrationSettings& settings,
                                                      const Job& job);

}  // namespace alltact
