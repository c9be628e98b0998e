// How presses become a mapping: what can be chosen, each choice declared once for flags, files and
// dialogs.
#pragma once

#include "core/settings.h"

#include <string>
#include <vector>

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

/// From family on, all are of the joint method.
struct CalibrationSettings {
  CalibrationMethod method = CalibrationMethod::kJoint;
  int presses = 0;              ///< that are used at most, evenly among those given; 0: all
  int pictures_per_press = 64;  ///< of a press held still, averaged at most
  FamilyChoice family = FamilyChoice::kAuto;
  int degree = 0;  ///< number of Chebyshev coefficients, 1..8; 0: chosen by leaving presses out
  AlongChoice along = AlongChoice::kAuto;
  OverFaceChoice over_face = OverFaceChoice::kAuto;
  int iterations = 60;  ///< rounds of reweighting, unless nothing moves any more before
};
[[nodiscard]] const std::vector<Setting<CalibrationSettings>>& calibration_settings();

/// As the setting `method` says it.
[[nodiscard]] std::string method_name(CalibrationMethod method);

}  // namespace alltact
