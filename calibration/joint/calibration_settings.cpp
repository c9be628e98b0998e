#include "calibration/joint/calibration_settings.h"

namespace alltact {

const std::vector<Setting<CalibrationSettings>>& calibration_settings() {
  using S = CalibrationSettings;
  static const std::vector<Setting<S>> settings{
      choice_setting<S, CalibrationMethod>("method",
                                           en::say("how presses become a mapping: all balls and "
                                                   "the mapping in one fit; or, to compare with, "
                                                   "every ball from its dark border alone: the "
                                                   "source paper's way, a circle on the face, or "
                                                   "the cone of the ball's outline"),
                                           &S::method,
                                           {{"joint", CalibrationMethod::kJoint},
                                            {"paper", CalibrationMethod::kPaper},
                                            {"circle", CalibrationMethod::kCircle},
                                            {"cone", CalibrationMethod::kCone}}),
      choice_setting<S, FamilyChoice>(
          "family",
          en::say("the mapping's curve; auto: whichever predicts presses left out best"),
          &S::family,
          {{"auto", FamilyChoice::kAuto},
           {"polynomial", FamilyChoice::kPolynomial},
           {"moebius", FamilyChoice::kMoebius},
           {"kubelka-munk", FamilyChoice::kLayer}}),
      number_setting<S>("degree",
                        en::say("degree of the polynomial; 0: chosen by leaving presses out"),
                        &S::degree,
                        0,
                        8),
      choice_setting<S, AlongChoice>(
          "along",
          en::say(
              "which thickness of the layer brightness follows: along z, along its normal, or that "
              "along z projected onto the normal; auto: along the normal unless presses left out "
              "say "
              "otherwise"),
          &S::along,
          {{"auto", AlongChoice::kAuto},
           {"z", AlongChoice::kZ},
           {"normal", AlongChoice::kNormal},
           {"projected", AlongChoice::kProjected}}),
      choice_setting<S, OverFaceChoice>(
          "over-face",
          en::say("whether the mapping may vary slowly over the face, for uneven light or an "
                  "uneven layer; "
                  "auto: when presses left out agree clearly better then"),
          &S::over_face,
          {{"auto", OverFaceChoice::kAuto}, {"even", OverFaceChoice::kEven}}),
  };
  return settings;
}

std::string method_name(CalibrationMethod method) {
  CalibrationSettings settings;
  settings.method = method;
  return calibration_settings().front().get(settings);
}

}  // namespace alltact
