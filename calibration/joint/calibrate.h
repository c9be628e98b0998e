// From ball presses to the depth mapping: all presses solved together.
//
// BACKGROUND
// A ball of known radius R is pressed into the face. Its image and the contact-free image of the
// face give every pixel a relative darkening x = (I_ref - I) / I_ref. Where the ball's centre c is
// known, geometry gives the press depth d at the same pixel. The mapping d = M(x) is the curve
// through these pairs. Nobody measures c, so centres and curve are estimated together.
//
// MODEL
// With g the inverse of M, d_i(c) the depth of the skin over the ball at sample i (joint_fit.h,
// contact_model.h), s_i = M'(g(d_i(c))) and sigma_i the noise of x_i as depth, the joint method
// minimises
//   sum_i rho(s_i (x_i - g(d_i(c))) / sigma_i)             brightness in the contacts
// + sum_k rho((angle(r_k, c) - asin(R / |c|)) / sigma_k)   rays r_k of the occluding contour
// + sum_p ((R - height_p(c) - h_p) / sigma_p)^2            measured depths h_p, where there are any
// + sum_q ((scale_q(M) - 1) / sigma_q)^2                   scale by other bodies of known shape
// and priors of a layer's absorption and of the lift-off length, by iteratively reweighted least
// squares; rho is the soft L1 loss. Samples are block means of the image. The face's own distance
// is known to 0.05 mm. The component of the rays' residuals that moves ball and face apart along z
// is weighted accordingly. Only the zone of a contact where skin and ball certainly touch is read,
// and more where that is needed and explained (choose_model()). The other methods
// (outline_methods.h) serve for comparison.
//
// GAUGE
// Camera and face are held fixed: they give the frame (the camera's, in mm) and the untouched
// surface; R gives the unit of depth. No direction is free then, but two are weak. An offset: the
// curve's low end takes up a common motion of all balls along the normal. M(0) = 0 is exact for
// this reason, and presses of different depths constrain the rest. A scale: only the contacts'
// curvature gives it. A radius that is wrong by 1 % makes depths wrong by about as much. Residuals
// hardly show it (Calibration::radius_sensitivity); a measured depth or another body does. With one
// press both directions are open, and a remark states it. Where the Jacobian is not of full rank
// the covariance is empty, and another remark states it.
//
// WHAT IS ESTIMATED
// Three numbers for each ball; the mapping's: two or three of a Kubelka-Munk layer, or up to eight
// Chebyshev coefficients, and two more where it varies over the face; the skin's lift-off length.
// Cross-validation over the presses chooses the family, the direction of the thickness that
// brightness follows, and whether the mapping varies. Covariances of balls and mapping are
// estimated, too. Where the brightness around the balls shows that the layer spreads light, balls,
// mapping and spread come from a fit of their own (light_spread_fit.h).
//
// WHAT IS NOT ESTIMATED
// Camera, lens distortion, layer thickness, the balls' radii, the face's shape in each image and
// the light. Calibrate the lens first, measure the balls, correct the illumination. Errors in these
// enter the mapping and no covariance here contains them. Shear of the skin, hysteresis and
// temperature are not modelled.
//
// EXAMPLE
//   int example(const std::vector<Press>& presses, const Camera& camera, const Face& face) {
//     const Job job([](double done, const Message& what) {
//       fmt::print("{:3.0f} % {}\n", 100 * done, what);
//     });
//     const Result<Calibration> result = calibrate(presses, camera, face, {}, job);
//     if (!result) return fmt::print("{}\n", result.error().sentence()), 1;
//     for (const Message& reason : result->left_out) fmt::print("Left out: {}\n", reason);
//     const Result<Mapping> mapping = Mapping::create(result->mapping);
//     fmt::print("x = 0.2 is {:.3f} mm deep\n", mapping->depth_mm(0.2));
//     return fmt::print("{:.3f} mm on presses left out\n", result->held_out_mm), 0;
//   }
#pragma once

#include "calibration/joint/calibration_settings.h"
#include "calibration/joint/joint_fit.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

// Progress of the joint fit, round by round.

/// State after one round of the joint fit.
struct Round {
  int number = 1;          ///< from 1; restarts with each stage of the calculation
  double residual_mm = 0;  ///< mean absolute inside the contacts, of the solution so far
  double change_mm = 0;    ///< how much the unknowns moved in this round
};

/// Called on the calibrating thread, which waits for it. Empty: the figures of a round are not
/// computed.
using RoundListener = std::function<void(const Round& round)>;

// Uncertainty of a joint fit: its weakest direction, the effect of a wrong radius, and the most
// useful next press.

/// The direction of the mapping's values that the presses determine least, by its effect on depths.
struct WeakestDirection {
  double depth_mm = 0;  ///< where on the curve its effect is largest
  double sd_mm = 0;     ///< standard deviation there
  /// all depths share the error's sign; false: shallow and deep ones differ in sign
  bool is_scale = true;
  Message sentence;
};
/// `covariance`: of curve.values(). Its principal component on depths over the domain.
[[nodiscard]] WeakestDirection weakest_direction(const MappingCurve& curve,
                                                 const Eigen::MatrixXd& covariance);

/// The effect of a radius that is wrong by 1 %, and whether the presses would show it.
struct RadiusSensitivity {
  double depth_part = 0;  ///< relative change of depths for a radius 1 % larger
  double smaller_mm = 0, given_mm = 0,
         larger_mm = 0;  ///< residual with 1 % less, as given, 1 % more
  bool is_seen = false;  ///< the given radius fits better than both by a tenth
  Message sentence;
};
/// Fits the presses again with a radius 1 % smaller and larger. nullopt when a fit fails or the job
/// is stopped.
[[nodiscard]] std::optional<RadiusSensitivity> vary_radius(
    const std::vector<const PressSamples*>& presses, const JointFit& fit,
    const JointOptions& options, const Job& job);

struct PressAdvice {
  bool enough = false;                               ///< another press would hardly help
  double along_mm = 0, across_mm = 0, depth_mm = 0;  ///< position and depth of the next press
  double sd_now_mm = 0, sd_then_mm = 0;  ///< of the depth, root mean square over the domain
  Message sentence;
};

/// Predicts the covariance with one more press, simulated at the position of each press made,
/// shallower, as deep and deeper. A third of the face without a press comes first, because nothing
/// shows whether the mapping holds there. face_length_mm: of the visible part. `enough` is true
/// where every third has a press and the best one would take less than a twentieth off.
[[nodiscard]] PressAdvice advise(const std::vector<const PressSamples*>& presses,
                                 const JointFit& fit, const JointOptions& options,
                                 double face_length_mm);

// The solution.

/// The ball of one press in the solution.
struct BallFit {
  std::string press;
  double radius_mm = 0;
  Eigen::Vector3d centre_mm;
  Eigen::Vector3d centre_sd_mm;
  double depth_mm = 0;     ///< greatest press depth along z
  double residual_mm = 0;  ///< joint method: error_of_press() of this mapping
  double held_out_mm = 0;  ///< of a mapping fitted without this press's position; 0: there was none
  double tangent_arc_deg = 0;  ///< of the outline that entered the fit; 0: brightness alone
  bool cut_by_edge = false;
  std::optional<GivenDepth> given_depth = std::nullopt;  ///< measured by a gauge or a stage
  double indentation_mm = 0;  ///< estimated, along the normal, as given_depth is
};

/// The punch of one press in the solution.
struct StepFit {
  std::string press;
  double step_mm = 0;       ///< height of the step, as specified
  double estimated_mm = 0;  ///< estimated by the mapping
  double sd_mm = 0;         ///< of the estimate alone
};

/// The body of one press in the solution.
struct BodyFit {
  std::string press;
  std::string body;  ///< its mesh's file name
  double scale = 1;  ///< depth by the mapping / depth by the body's shape
  double sd = 0;     ///< of that estimate alone
};

struct Calibration {
  MappingParameters mapping;
  std::vector<BallFit> balls;
  std::vector<StepFit> steps;   ///< joint method only
  std::vector<BodyFit> bodies;  ///< likewise
  double residual_mm = 0;
  double held_out_mm = 0;  ///< 0 when there was only one press
  /// Common error of all depths, mean absolute over the domain. It is the larger of the jackknife
  /// over presses and the mapping's covariance. The balls take this error up, so held_out_mm does
  /// not contain it. 0 with one press and with methods other than the joint one.
  double spread_mm = 0;
  double condition = 0;  ///< of the scaled problem
  /// Probability, by the presses, that light spreads in the layer although the mapping has none; 1:
  /// not tested, 0: the mapping has it.
  double undetected_spread = 1;
  Message degree_choice;          ///< why this family and degree, a sentence
  std::vector<Message> left_out;  ///< presses not used, each with its reason
  std::vector<Message> remarks;   ///< for the user (one press only, ...)
  std::optional<WeakestDirection>
      weakest;  ///< joint method, when the presses determine every unknown
  std::optional<PressAdvice> next_press;                ///< joint method; empty when stopped before
  std::optional<RadiusSensitivity> radius_sensitivity;  ///< joint method; empty when stopped before
};

/// Balls may be of several sizes; the order of the presses does not change the solution. Any
/// thread. Errors: an impossible radius, no usable press (with each press's reason), a solution
/// that is not finite or not increasing. A stopped job returns the best solution so far when there
/// is one. `on_round` is called for each round of the joint method's last solution; the other
/// methods have no rounds.
[[nodiscard]] Result<Calibration> calibrate(const std::vector<Press>& presses, const Camera& camera,
                                            const Face& face, const CalibrationSettings& settings,
                                            const Job& job, const RoundListener& on_round = {});

// Comparison of the methods on the same presses.

/// Result of one method. Where `failed` is not empty other fields are unset.
struct MethodRow {
  CalibrationMethod method = CalibrationMethod::kJoint;
  int presses = 0;            ///< with a ball found
  double press_depth_mm = 0;  ///< greatest depth of the ball, mean over presses
  double residual_mm = 0;     ///< mean absolute, of its own mapping on its own balls
  double at_depth_mm = 0;     ///< depth by this method where the joint method's mapping reads...
  double joint_depth_mm = 0;  ///< ...this, which lies within both domains
  Message failed;             ///< why there is no mapping
};

/// `joint` is the solution of calibrate() for these presses; circle and cone are run on them
/// unchanged. `as_paper`: the same presses measured by the source paper's method, for its row, or
/// why that failed. Rows: joint, paper, circle, cone; fewer when the job was stopped.
[[nodiscard]] std::vector<MethodRow> compare_methods(const std::vector<Press>& presses,
                                                     const Result<std::vector<Press>>& as_paper,
                                                     const Camera& camera, const Face& face,
                                                     const Calibration& joint, const Job& job);

}  // namespace alltact
