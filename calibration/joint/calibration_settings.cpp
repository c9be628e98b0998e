#include "calibration/joint/calibration_settings.h"

namespace alltact {

const std::vector<Setting<CalibrationSettings>>& calibration_settings() {
  using S = CalibrationSettings;
  static const std::vector<Setting<S>> settings{
      with_trade_off(choice_setting<S, CalibrationMethod>(
                         "method",
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
                     {en::say("'joint' is several times closer, and says how sure it is"),
                      en::say("'joint' solves all presses together, which takes seconds"),
                      {"paper", "circle", "cone", "joint"}}),
      with_trade_off(
          number_setting<S>("presses",
                            en::say("presses that are used at most, spread evenly over those "
                                    "given; 0: all of them"),
                            &S::presses,
                            0,
                            1000),
          {en::say("more hold the curve at more depths and places; ten well spread are usual"),
           en::say("each has to be made, and is left out once to see what it predicts"),
           {"1", "2", "3", "4", "5", "6", "7", "8", "10", "12", "16", "24", "0"}}),
      with_trade_off(
          number_setting<S>("pictures-per-press",
                            en::say("pictures of a press held still (--bursts) that are "
                                    "averaged at most"),
                            &S::frames_per_press,
                            1,
                            64),
          {en::say("more leave less noise in a press, by their square root"),
           en::say("the ball has to be held still for so long, and reading them takes a little"),
           {"1", "4", "16", "64"}}),
      with_trade_off(
          choice_setting<S, FamilyChoice>(
              "family",
              en::say("the mapping's curve; auto: whichever predicts presses left out best"),
              &S::family,
              {{"auto", FamilyChoice::kAuto},
               {"polynomial", FamilyChoice::kPolynomial},
               {"moebius", FamilyChoice::kMoebius},
               {"kubelka-munk", FamilyChoice::kLayer}}),
          {en::say("'moebius' and 'kubelka-munk' need few presses where the layer is even; "
                   "'polynomial' follows any layer, given more of them"),
           en::say("'auto' fits all of them and leaves presses out of each"),
           {"moebius", "polynomial", "kubelka-munk", "auto"}}),
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
      choice_setting<S, FaceVariationChoice>(
          "over-face",
          en::say("whether the mapping may vary slowly over the face, for uneven light or an "
                  "uneven layer; "
                  "auto: when presses left out agree clearly better then"),
          &S::face_variation,
          {{"auto", FaceVariationChoice::kAuto}, {"even", FaceVariationChoice::kEven}}),
      with_trade_off(
          number_setting<S>("iterations",
                            en::say("rounds of the joint fit at most; it ends before when "
                                    "nothing moves any more"),
                            &S::iterations,
                            1,
                            60),
          {en::say("more settle what presses say against each other; too few leave the curve "
                   "where it began"),
           en::say("each solves all presses together once, in every trial"),
           {"1", "2", "4", "60"}}),
  };
  return settings;
}

std::string method_name(CalibrationMethod method) {
  CalibrationSettings settings;
  settings.method = method;
  return calibration_settings().front().get(settings);
}

}  // namespace alltact
