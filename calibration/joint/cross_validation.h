// Cross-validation: fits without one press after the other, their errors on the press left out, and
// a comparison of two such series.
#pragma once

#include "calibration/joint/starting_curve.h"
#include "core/job.h"

#include <vector>

namespace alltact {

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
[[nodiscard]] double error_of_press(const PressSamples& press,
                                    const JointFit& mapping,
                                    const Eigen::Vector3d& centre_mm,
                                    const JointOptions& options,
                                    const Job& job);

/// Presses whose contacts lie closer together than the larger one's radius share a position. They
/// are left out together, because a repeat would predict its likes. With fewer than three positions
/// each press is left out separately. One error for each press, fewer when the job was stopped.
/// Errors are infinite where the other presses gave no increasing curve: a family that one press
/// can lead astray is not reliable. `all`: the fit of all presses, to start from.
[[nodiscard]] HeldOutPresses hold_out(const ChoiceInput& input,
                                      const JointFit& all,
                                      const JointOptions& options,
                                      const Job& job);

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
