// Settings of a calibration, each declared once for flags, files and dialogs.
#pragma once

#include "core/base/settings.h"

#include <string>
#include <vector>

namespace alltact {

enum class CalibrationMethod {
  kJoint = 1,  ///< all ball centres and the mapping in one robust least-squares problem
  // Every ball alone from its dark border, then one polynomial (outline_methods.h):
  kPaper,   ///< the source paper: a circle, its depth by its radius and a constant of zero
  kCircle,  ///< a circle on the face where the skin leaves the ball
  kCone,    ///< the cone tangent to the ball's outline
};
enum class FamilyChoice { kAuto = 1, kPolynomial, kMoebius, kLayer };
/// Whether the mapping may vary over the face.
enum class FaceVariationChoice { kAuto = 1, kEven };
enum class AlongChoice { kAuto = 1, kZ, kNormal, kProjected };
/// Whether light may come back next to where it went in.
enum class LightSpreadChoice { kAuto = 1, kLocal };

/// `family` and all settings after it apply to the joint method only.
struct CalibrationSettings {
  CalibrationMethod method = CalibrationMethod::kJoint;
  int presses = 0;            ///< used at most, evenly spread over those given; 0: all
  int frames_per_press = 64;  ///< averaged at most, of a press held still
  FamilyChoice family = FamilyChoice::kAuto;
  int degree = 0;  ///< number of Chebyshev coefficients, 1..8; 0: chosen by cross-validation
  AlongChoice along = AlongChoice::kAuto;
  FaceVariationChoice face_variation = FaceVariationChoice::kAuto;
  LightSpreadChoice light_spread = LightSpreadChoice::kAuto;
  /// rounds of reweighting at most; the fit ends earlier when it has converged
  int iterations = 60;
};
[[nodiscard]] const std::vector<Setting<CalibrationSettings>>& calibration_settings();

/// The value of the setting `method`.
[[nodiscard]] std::string method_name(CalibrationMethod method);

}  // namespace alltact
