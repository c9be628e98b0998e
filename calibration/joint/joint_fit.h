// All ball centres and the mapping in one robust weighted least-squares problem.
//
// A ball of radius R, its press's own, at c gives every sample inside its contact a depth d(c). The
// inverse mapping gives the difference g(d) for that depth. The noise is in the image, so the fit
// minimises sum ((x_i - g(d_i(c))) / sigma_i)^2, robustly. It reads the zone of every contact where
// skin and ball certainly touch. Residuals of depth, M(x_i) - d_i, would make all depths too small
// by 2 to 12 % at ordinary noise. The cause is regression dilution: a straight line through points
// that are uncertain along it comes out too flat. Where part of the ball's outline is seen
// (outline_methods.h), the angles of its rays to the centre, less asin(R / |c|), join the sum. So
// do measured depths of presses and the scale by other bodies of known shape.
#pragma once

#include "calibration/joint/calibration_settings.h"
#include "calibration/joint/contact_model.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/message.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct JointFit;
struct KnownShape;

struct JointOptions {
  MappingAlong along = MappingAlong::kZ;
  double zone = kInnerZone;  ///< contacts are read up to this fraction of the rim's radius
  double settled_mm = 1e-8;  ///< the reweighting ends when no unknown changes by more
  int max_rounds = 60;       ///< of reweighting
  bool fix_mapping = false;  ///< only the balls are free
  bool free_lift = false;    ///< the lift-off length is an unknown, shared by all presses
  /// Bodies whose shapes the mapping shall reproduce; may be null.
  const std::vector<KnownShape>* shapes = nullptr;
  /// Called after every round with the change of the unknowns, mm, and the fit; may be empty.
  std::function<void(int round, double change_mm, const JointFit& now)> watch = {};
};

/// The state of a fit: its start and its result.
struct JointFit {
  MappingCurve curve;
  std::vector<Eigen::Vector3d> centres_mm;  ///< one for each press
  bool converged = false;                   ///< finite, and the unknowns no longer change
  double lift_mm = 0;  ///< of contact_model.h; 0: the skin leaves the ball at the rim
};

/// Improves `start`. A stopped job returns the best fit so far.
[[nodiscard]] JointFit fit_jointly(const std::vector<const PressSamples*>& presses, JointFit start,
                                   const JointOptions& options, const Job& job);

/// Quality of a solution by its residuals.
struct FitQuality {
  std::vector<double> residual_mm;  ///< mean absolute in the zone, one a press
  double ring_mm = 0;     ///< root mean square of the rings' mean residuals over all presses
  double scatter_mm = 0;  ///< expected ring_mm by the scatter of the sectors alone
  int rings = 0;
  double lifted_sd_mm = 0;  ///< rms over the rings of the sd by the lift-off
};
[[nodiscard]] FitQuality quality_of(const std::vector<const PressSamples*>& presses,
                                    const JointFit& fit, const JointOptions& options);

/// Covariance of (mapping values, centres in order; then the lift-off's logarithm if it was free)
/// by the solution's own residuals; empty when the problem is singular, 0 for fixed unknowns.
/// Neighbouring samples share noise, by the correlation of their residuals. Each patch of a contact
/// has a common error, by the patches' scatter beyond that noise. Each ring has an error common to
/// all presses, by the rings' mean residuals, at least 0.003 mm, which no press would show. Rings
/// outside the inner zone may hide as much again as the mean of a ring scatters: noise must not
/// make a rim look certain. The form of the lift-off adds an error of each ring (kLiftPart). The
/// optics' blur adds an error common to all presses. `condition` (may be null): of the scaled
/// problem; 0 when it is singular.
[[nodiscard]] Eigen::MatrixXd covariance_of(const std::vector<const PressSamples*>& presses,
                                            const JointFit& fit, const JointOptions& options,
                                            double* condition = nullptr);
/// The same without the errors of rings and optics that are common to all presses.
[[nodiscard]] Eigen::MatrixXd chance_covariance_of(const std::vector<const PressSamples*>& presses,
                                                   const JointFit& fit,
                                                   const JointOptions& options);

// Start of the joint fit: the balls as found, and the mapping that follows from them.

/// Presses and their start: the balls as found, one a press, and the other bodies.
struct ChoiceInput {
  std::vector<const PressSamples*> presses;
  std::vector<Eigen::Vector3d> centres_mm;
  const std::vector<KnownShape>* shapes = nullptr;  ///< see JointOptions
  int max_rounds = 60;                              ///< likewise
};

inline constexpr CurveFamily kMoebiusFamily{MappingKind::kMoebius, 2};
inline constexpr CurveFamily kLayerFamily{MappingKind::kMoebius, 3};

/// The end of the domain: the largest difference in the inner zones of the contacts and on the
/// other bodies. 0: nothing is darker than the reference.
[[nodiscard]] double domain_of(const ChoiceInput& input, MappingAlong along);

/// A straight line through the balls as found, over the domain up to `x_max`.
[[nodiscard]] JointFit straight_start(const ChoiceInput& input, MappingAlong along, double x_max);

/// The same curve in another family where that contains it, else the straight line to its end.
/// Balls and lift-off length stay.
[[nodiscard]] JointFit as_family(const JointFit& fit, CurveFamily family);

// Choice of the direction of the thickness, the family of the mapping and the zone of the contacts
// by cross-validation over the presses.

struct ModelChoice {
  JointOptions options;             ///< `along` and `zone`
  JointFit fit;                     ///< of the chosen family, as a start
  std::vector<double> held_out_mm;  ///< one for each press; empty with one press
  double spread_mm = 0;             ///< see Calibration::spread_mm; 0 with one press
  Message sentence;                 ///< the reason
  std::vector<Message> remarks;
};

/// Families are compared by their mean absolute error inside the contact of a held-out press, to
/// which only the ball is fitted. The simplest wins that is worse than the best by no more than
/// 2.5 standard errors, the layer's before polynomials of two and more coefficients.
///
/// Contacts are read within 0.65 of their rim, where skin and ball touch on any material (Hertz:
/// 0.71), or in a wider zone where that makes all depths more certain, by chance and by the errors
/// that presses share: the inner zone leaves open an offset of all balls, which a curve that is
/// not quite the layer's takes up. A measured depth or another body that determines the scale to a
/// hundredth settles it, and the inner zone alone is read. The zone reaches as far out as skin and
/// ball touch by the lift-off (contact_model.h) that all presses determine, and as the common
/// residuals of the rings are explained. The direction of the thickness is chosen first, by the
/// family of layers. With five presses and more the mapping may vary over the face, when held-out
/// presses agree clearly better then. nullopt when no family gave an increasing curve, or the job
/// was stopped before one had.
[[nodiscard]] std::optional<ModelChoice> choose_model(const ChoiceInput& input,
                                                      const CalibrationSettings& settings,
                                                      const Job& job);

/// The error of a mapping in one press, mm, mean absolute in the inner zone of its contact
/// (kInnerZone). The ball is fitted to that zone alone, from `centre_mm` on. The mapping and the
/// lift-off length of `mapping` are fixed. It measures both residuals (the mapping was fitted to
/// the press) and held-out presses (it was not). Infinite where no ball fits.
[[nodiscard]] double error_of_press(const PressSamples& press, const JointFit& mapping,
                                    const Eigen::Vector3d& centre_mm, const JointOptions& options,
                                    const Job& job);

}  // namespace alltact
