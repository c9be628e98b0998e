// Chooses the direction of the thickness, the family of the mapping and the zone of the contacts by
// cross-validation over the presses.
#pragma once

#include "calibration/joint/calibration_settings.h"
#include "calibration/joint/joint_fit.h"
#include "core/base/job.h"
#include "core/base/message.h"

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
/// reaches as far out as skin and ball touch by the lift-off (contact_model.h) that all presses
/// determine, and as the common residuals of the rings are explained. The direction of the
/// thickness is chosen first, by the family of layers. With five presses and more the mapping may
/// vary over the face, when held-out presses agree clearly better then. nullopt when no family gave
/// an increasing curve, or the job was stopped before one had.
[[nodiscard]] std::optional<ModelChoice> choose_model(const ChoiceInput& input,
                                                      const CalibrationSettings& settings,
                                                      const Job& job);

// Cross-validation: fits without one press after the other, their errors on the press left out, and
// a comparison of two such series.

inline constexpr int kDomainPoints = 12;  // of the curve, where curves are compared
// Held-out errors closer than this are ties. The balls take up ten times as much of a wrong scale
// as they leave visible, so noise must not decide.
inline constexpr double kTieMm = 0.001;
inline constexpr double kSettledMm = 1e-5;  // precise enough for a choice of the model

/// Result of leaving positions on the face out, one after the other.
struct HeldOutPresses {
  /// Of each press, mean absolute: error_of_press() of the mapping fitted without its position.
  std::vector<double> errors_mm;
  std::vector<MappingCurve> curves;  ///< one for each position
};

/// The error of a mapping in one press, mm, mean absolute in the inner zone of its contact
/// (kInnerZone). The ball is fitted to that zone alone, from `centre_mm` on. The mapping and the
/// lift-off length of `mapping` are fixed. It measures both residuals (the mapping was fitted to
/// the press) and held-out presses (it was not). Infinite where no ball fits.
[[nodiscard]] double error_of_press(const PressSamples& press, const JointFit& mapping,
                                    const Eigen::Vector3d& centre_mm, const JointOptions& options,
                                    const Job& job);

/// Presses whose contacts lie closer together than the larger one's radius share a position. They
/// are left out together, because a repeat would predict its likes. With fewer than three positions
/// each press is left out separately. One error for each press, fewer when the job was stopped.
/// Errors are infinite where the other presses gave no increasing curve: a family that one press
/// can lead astray is not reliable. `all`: the fit of all presses, to start from.
[[nodiscard]] HeldOutPresses hold_out(const ChoiceInput& input, const JointFit& all,
                                      const JointOptions& options, const Job& job);

/// The jackknife's mean absolute depth error of a curve over the domain; 0 for fewer than two
/// curves.
[[nodiscard]] double spread_of(const std::vector<MappingCurve>& curves);

[[nodiscard]] double mean_mm(const std::vector<double>& values);

/// How much larger the errors a are than b on the same presses, and the standard error of that.
struct Excess {
  double mean, standard_error;
};
[[nodiscard]] Excess excess_of(const std::vector<double>& a, const std::vector<double>& b);

/// Whether the errors `a` of a simpler family are no worse than `b`, within the tolerance of a tie.
[[nodiscard]] bool is_no_worse(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace alltact
