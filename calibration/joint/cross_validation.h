// Cross-validation: fits without one press after the other, what they say of the press left out,
// and how the scores of two such series compare.
#pragma once

#include "calibration/joint/starting_curve.h"
#include "core/job.h"

#include <vector>

namespace alltact {

inline constexpr int kDomainPlaces = 12;  // of the curve, where curves are compared
// Held-out errors closer than this are the same: the balls, which take up ten times as much of a
// wrong scale as they leave to be seen, must not be led by noise.
inline constexpr double kTieMm = 0.001;
inline constexpr double kSettledMm = 1e-5;  // enough to choose by

/// What leaving positions on the face out, one after the other, shows.
struct HeldOutPresses {
  /// Of each press, mean absolute: error_of_press() of the mapping that its position was left out
  /// of.
  std::vector<double> errors_mm;
  std::vector<MappingCurve> curves;  ///< one a position
};

/// What a mapping is off by in one press, mean absolute in the part of its contact that surely
/// touches (kSureZone), mm. The ball is fitted to that part alone, with the mapping and the
/// lift-off length of `mapping` fixed, from `centre_mm` on. The one measure of residuals (the press
/// was among those that the mapping was fitted to) and of presses left out (it was not). Infinite
/// where no ball fits.
[[nodiscard]] double error_of_press(const PressSamples& press,
                                    const JointFit& mapping,
                                    const Eigen::Vector3d& centre_mm,
                                    const JointOptions& options,
                                    const Job& job);

/// Presses whose contacts lie closer together than the larger one's radius are at one position and
/// are left out together: a repeat would tell what its likes should show. With fewer than three
/// positions each press is left out alone. One error a press, fewer when the job was stopped.
/// Errors are infinite where the others did not come to an increasing curve: a family that leaving
/// one press out sends astray is not to be trusted with all of them either. `all`: the fit of all
/// presses, to start from.
[[nodiscard]] HeldOutPresses hold_out(const ChoiceInput& input,
                                      const JointFit& all,
                                      const JointOptions& options,
                                      const Job& job);

/// Mean absolute error of depth over the domain that the jackknife gives for a curve; 0 for less
/// than two curves.
[[nodiscard]] double spread_of(const std::vector<MappingCurve>& curves);

[[nodiscard]] double mean_mm(const std::vector<double>& values);

/// How much worse a is than b on the same presses, and the standard error of that.
struct Excess {
  double mean, standard_error;
};
[[nodiscard]] Excess excess_of(const std::vector<double>& a, const std::vector<double>& b);

/// True when a family's errors `a` are not worth leaving it for a less simple one with errors `b`.
[[nodiscard]] bool as_good(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace alltact
