// All ball centres and the mapping in one robust weighted least-squares problem.
//
// A ball of radius R, its press's own, at c gives every sample inside its contact a depth d(c), and
// the mapping, turned round, the difference g(d) that belongs to it. The noise is in the picture:
// minimise sum ((x_i - g(d_i(c))) / sigma_i)^2, robustly, over the part of every contact where skin
// and ball certainly touch (the zone). Residuals of depth, M(x_i) - d_i, would make all depths too
// small, as a straight line through points comes out too flat that are uncertain along it: by 2 to
// 12 % at ordinary noise. Where part of the ball's outline is seen (tangent_arc.h), the angles of
// its rays to the centre, less asin(R / |c|), join the sum. So does what was measured beside the
// pictures: how deep a press is, and how high the step of a punch.
#pragma once

#include "calibration/joint/mapping_curve.h"
#include "calibration/joint/sample_misfit.h"
#include "calibration/joint/step_press.h"
#include "calibration/presses/press_samples.h"
#include "core/job.h"

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct JointFit;

struct JointOptions {
  MappingAlong along = MappingAlong::kZ;
  double zone = kSureZone;   ///< contacts are read up to this part of the rim's radius
  double settled_mm = 1e-8;  ///< the reweighting ends when no unknown changes by more
  int most_rounds = 60;      ///< of reweighting
  bool fix_mapping = false;  ///< only the balls are free
  bool free_lift = false;    ///< the lift-off length is an unknown, shared by all presses
  /// Punches whose steps the mapping is to read right; may be null.
  const std::vector<StepSamples>* steps = nullptr;
  /// Told after every round how much the unknowns still moved, mm, and where to; may be null.
  const std::function<void(int round, double change_mm, const JointFit& now)>* watch = nullptr;
};

/// The state of a fit: what to start from, and what came out.
struct JointFit {
  MappingCurve curve;
  std::vector<Eigen::Vector3d> centres_mm;  ///< one a press
  bool converged = false;                   ///< finite and settled
  double lift_mm = 0;                       ///< of lift_off.h; 0: skin and ball part at the rim
};

/// Improves `start`. A stopped job ends it early with the best so far.
[[nodiscard]] JointFit fit_jointly(const std::vector<const PressSamples*>& presses,
                                   JointFit start,
                                   const JointOptions& options,
                                   const Job& job);

/// What the residuals at a solution say.
struct FitQuality {
  std::vector<double> residual_mm;  ///< mean absolute in the zone, one a press
  double ring_mm = 0;     ///< root mean square of the rings' mean residuals over all presses
  double scatter_mm = 0;  ///< what ring_mm would be from the sectors' scatter alone
  int rings = 0;
  double lifted_sd_mm = 0;  ///< root mean square over the rings of what the lift-off leaves open
};
[[nodiscard]] FitQuality quality_of(const std::vector<const PressSamples*>& presses,
                                    const JointFit& fit,
                                    const JointOptions& options);

/// Covariance of (mapping values, centres in order; then the lift-off's logarithm if it was free)
/// and the condition of the scaled problem.
struct JointCovariance {
  Eigen::MatrixXd covariance;  ///< empty when the problem is singular; 0 for what was fixed
  double condition = 0;
};
/// Spread of the solution as the residuals themselves show it. Neighbouring samples share their
/// noise, by as much as their residuals do; each patch of a contact may be off as a whole, by what
/// the patches scatter beyond that; and each ring, in all presses alike, by what the rings' mean
/// residuals are and at least by 0.003 mm, which no press would show. Rings outside the sure zone
/// may hide as much again as the mean of a ring scatters: noise must not make a rim look certain;
/// what the form of the lift-off leaves open (kLiftPart), each ring by itself; and what the optics'
/// blur leaves open, in all presses alike.
[[nodiscard]] JointCovariance covariance_of(const std::vector<const PressSamples*>& presses,
                                            const JointFit& fit,
                                            const JointOptions& options);
/// The same without what rings and optics are off by in all presses alike.
[[nodiscard]] JointCovariance chance_covariance_of(const std::vector<const PressSamples*>& presses,
                                                   const JointFit& fit,
                                                   const JointOptions& options);

}  // namespace alltact
