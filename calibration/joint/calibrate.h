// From ball presses to the depth mapping: all presses solved together.
#pragma once

#include "calibration/joint/press_advice.h"
#include "calibration/presses/press.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/result.h"
#include "core/settings.h"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

enum class CalibrationMethod {
  kJoint = 1,  ///< all ball centres and the mapping in one robust least-squares problem
  // Every ball by itself from its dark border, then one polynomial (outline_methods.h):
  kPaper,   ///< the source paper: a circle, its depth by its radius and a constant of zero
  kCircle,  ///< a circle where ball and face part
  kCone,    ///< the cone that touches the ball's outline
};
enum class FamilyChoice { kAuto = 1, kPolynomial, kMoebius, kLayer };
/// Whether the mapping may vary over the face.
enum class OverFaceChoice { kAuto = 1, kEven };
enum class AlongChoice { kAuto = 1, kZ, kNormal, kProjected };

struct CalibrationSettings {
  CalibrationMethod method = CalibrationMethod::kJoint;
  FamilyChoice family = FamilyChoice::kAuto;
  int degree = 0;  ///< number of Chebyshev coefficients, 1..8; 0: chosen by leaving presses out
  AlongChoice along = AlongChoice::kAuto;
  OverFaceChoice over_face = OverFaceChoice::kAuto;
};
[[nodiscard]] const std::vector<Setting<CalibrationSettings>>& calibration_settings();

/// As the setting `method` says it.
[[nodiscard]] std::string method_name(CalibrationMethod method);

/// The ball of one press in the solution.
struct BallFit {
  std::string press;
  double radius_mm = 0;
  Eigen::Vector3d centre_mm;
  Eigen::Vector3d centre_sd_mm;
  double depth_mm = 0;         ///< greatest press depth along z
  double residual_mm = 0;      ///< mean absolute, inside the contact
  double held_out_mm = 0;      ///< the same with a mapping fitted without this press; 0: only press
  double tangent_arc_deg = 0;  ///< of the outline that entered the fit; 0: brightness alone
  bool cut_by_edge = false;
  std::optional<ToldDepth> told_depth = std::nullopt;  ///< as it was measured
  double pressed_in_mm = 0;                            ///< what the solution says of that
};

/// The punch of one press in the solution.
struct StepFit {
  std::string press;
  double step_mm = 0;   ///< as it was told
  double reads_mm = 0;  ///< as the mapping reads it
  double sd_mm = 0;     ///< of the reading by itself
};

struct Calibration {
  MappingParameters mapping;
  std::vector<BallFit> balls;
  std::vector<StepFit> steps;  ///< joint method only
  double residual_mm = 0;
  double held_out_mm = 0;  ///< 0 when there was only one press
  /// How far depth is off as a whole, mean absolute over the domain: the larger of what the mapping
  /// changes when presses are left out (jackknife) and its covariance. The balls take this up, so
  /// that held_out_mm cannot see it. 0 with one press and with methods other than the joint one.
  double spread_mm = 0;
  double condition = 0;               ///< of the scaled problem
  std::string degree_choice;          ///< why this family and degree, a sentence
  std::vector<std::string> left_out;  ///< presses not used, each with the reason
  std::vector<std::string> remarks;   ///< what the user should know (one press only, ...)
  std::optional<Weakness> weakness;   ///< joint method, when the presses determine every unknown
  std::optional<PressAdvice> next_press;    ///< joint method; absent when stopped before
  std::optional<RadiusSense> radius_sense;  ///< the same
};

/// Balls may be of several sizes. Errors: an impossible radius, no usable press (with each press's
/// reason), a solution that is not finite or not
/// increasing. A stopped job returns the best solution so far when there is one.
[[nodiscard]] Result<Calibration> calibrate(const std::vector<Press>& presses,
                                            const Camera& camera,
                                            const Face& face,
                                            const CalibrationSettings& settings,
                                            const Job& job);

}  // namespace alltact
