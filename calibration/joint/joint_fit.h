// All ball centres and the mapping in one robust weighted least-squares problem.
//
// A ball of radius R, its press's own, at c gives every sample inside its contact a depth d(c), and
// the mapping, turned round, the difference g(d) that belongs to it. The noise is in the picture:
// minimise sum ((x_i - g(d_i(c))) / sigma_i)^2, robustly, over the part of every contact where skin
// and ball certainly touch (the zone). Residuals of depth, M(x_i) - d_i, would make all depths too
// small, as a straight line through points comes out too flat that are uncertain along it: by 2 to
// 12 % at ordinary noise. Where part of the
// ball's outline is seen (tangent_arc.h), the angles of its rays to the centre, less asin(R / |c|),
// join the sum. So does what was measured beside the pictures: how deep a press is, and how high
// the step of a punch.
#pragma once

#include "calibration/joint/lift_off.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/joint/step_press.h"
#include "calibration/presses/press_samples.h"
#include "core/job.h"

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// How deep a ball presses in at a sample, mm, in the sense of `along`, negative where the ball
/// is off the face; with its derivative by the centre. NaN where the line misses the ball.
[[nodiscard]] double ball_depth_mm(const Sample& sample,
                                   MappingAlong along,
                                   const Eigen::Vector3d& centre_mm,
                                   double radius_mm,
                                   Eigen::Vector3d* by_centre = nullptr);

/// How deep the skin is pressed in at a sample by a ball that it leaves as lift_off.h says, in the
/// sense of `along`; with derivatives by the centre and by the lift-off length (may be null).
[[nodiscard]] double skin_depth_mm(const Sample& sample,
                                   MappingAlong along,
                                   const Eigen::Vector3d& centre_mm,
                                   double radius_mm,
                                   const ContactPlane& plane,
                                   double lift_mm,
                                   Eigen::Vector3d* by_centre = nullptr,
                                   double* by_lift = nullptr);

/// What a sample reads a ball deeper by than the ball is at its middle, mm: it is a mean over some
/// pixels (PressSamples::blur_px2), and a mean over what is curved is not its middle. By the second
/// derivatives of x = g(d) over the picture, g the curve's inverse:
///   blur / 2 (laplacian d - M'' / M'^2 |gradient d|^2).
/// Two thousandths of a millimetre in the middle of a contact are a hundredth in the scale of all
/// depths, because the ball gives way. 0 where the ball's edge is near.
[[nodiscard]] double blur_mm(const Sample& sample,
                             const PressSamples& press,
                             const MappingCurve& curve,
                             MappingAlong along,
                             const Eigen::Vector3d& centre_mm,
                             const ContactPlane& plane = {},
                             double lift_mm = 0.0);

/// What a sample differs by from the ball: slope (x - g(d)), the noise of x as depth, mm. NaN where
/// the ball or the curve gives none.
struct Misfit {
  double mm = 0;
  double slope_mm = 0;   ///< dM/dx where M gives the ball's depth
  double blur_mm = 0;    ///< see blur_mm()
  double lifted_mm = 0;  ///< what the skin is off the ball by, outwards of where they part
};
[[nodiscard]] Misfit misfit_of(const Sample& sample,
                               const PressSamples& press,
                               const MappingCurve& curve,
                               MappingAlong along,
                               const Eigen::Vector3d& centre_mm,
                               const ContactPlane& plane = {},
                               double lift_mm = 0.0);

/// Where in the contact the samples lie: 0 at its middle, 1 at the rim of the ball's cap, where
/// face and ball part if the skin followed the ball to the end.
class ContactDisc {
 public:
  ContactDisc(const PressSamples& press, MappingAlong along, const Eigen::Vector3d& centre_mm);

  /// Where the skin over a sample touches the ball.
  struct Place {
    double radius;  ///< part of the rim's; infinite where the sample's line misses the ball
    int patch;      ///< 0..kPatches-1: rings as below, 8 sectors each
  };
  [[nodiscard]] Place place_of(const Sample& sample) const;
  /// The untouched face below the ball.
  [[nodiscard]] const ContactPlane& plane() const { return plane_; }
  static constexpr int kRings = 7;
  static constexpr int kSectors = 8;
  static constexpr int kPatches = kRings * kSectors;
  /// Outer radii of the rings.
  static constexpr double kRingRadius[kRings] = {0.35, 0.5, 0.65, 0.75, 0.85, 0.93, 1.0};

 private:
  MappingAlong along_;
  Eigen::Vector3d centre_mm_;
  double radius_mm_;
  ContactPlane plane_;
  double rim2_ = 1;  ///< squared radius of the cap's rim
};

/// Part of the rim's radius within which skin and ball touch on any material (Hertz: 0.71).
constexpr double kSureZone = 0.65;
constexpr double kFloorMm = 0.003;  ///< no sample is believed better than this, across the ball

struct JointFit;

struct JointOptions {
  MappingAlong along = MappingAlong::kZ;
  double zone = kSureZone;   ///< contacts are read up to this part of the rim's radius
  double settled_mm = 1e-8;  ///< the reweighting ends when no unknown changes by more
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
