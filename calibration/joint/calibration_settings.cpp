#include "calibration/joint/calibration_settings.h"

namespace alltact {

const std::vector<Setting<CalibrationSettings>>& calibration_settings() {
  using S = CalibrationSettings;
  const auto method = [](const std::string& word) { return en::say("method {}", word); };
  const auto family = [](const std::string& word) { return en::say("family {}", word); };
  static const std::vector<Setting<S>> settings{
      with_trade_off(
          choice_setting<S, CalibrationMethod>(
              "method",
              en::say("how presses become a mapping: all balls and the mapping in one fit; or, for "
                      "comparison, every ball from its dark border alone: by the source paper, as "
                      "a circle on the face, or as the cone of the ball's outline"),
              &S::method,
              {{"joint", CalibrationMethod::kJoint, method("joint")},
               {"paper", CalibrationMethod::kPaper, method("paper")},
               {"circle", CalibrationMethod::kCircle, method("circle")},
               {"cone", CalibrationMethod::kCone, method("cone")}}),
          {en::say("'joint' is several times more accurate, and reports its certainty"),
           en::say("'joint' solves all presses together, which takes seconds"),
           {"paper", "circle", "cone", "joint"}}),
      with_trade_off(
          number_setting<S>("presses",
                            en::say("maximum number of presses to use, spread evenly over those "
                                    "given; 0: all of them"),
                            &S::presses, 0, 1000,
                            [](int n) {
                              return n == 0 ? en::say("all presses")
                                            : en::count("{} presses", "{} press", n);
                            }),
          {en::say(
               "more support the curve at more depths and positions; ten well spread are typical"),
           en::say("each must be made, and is left out once to test the prediction"),
           {"1", "2", "3", "4", "5", "6", "7", "8", "10", "12", "16", "24", "0"}}),
      with_trade_off(
          number_setting<S>(
              "pictures-per-press",
              en::say("maximum number of averaged images of a press held still (--bursts)"),
              &S::frames_per_press, 1, 64,
              [](int n) { return en::count("{} images each", "{} image each", n); }),
          {en::say("more leave less noise in a press, by their square root"),
           en::say("the ball must be held still that long, and reading them takes a little time"),
           {"1", "4", "16", "64"}}),
      with_trade_off(
          choice_setting<S, FamilyChoice>(
              "family",
              en::say("the mapping's curve; auto: whichever best predicts presses left out"),
              &S::family,
              {{"auto", FamilyChoice::kAuto, family("auto")},
               {"polynomial", FamilyChoice::kPolynomial, family("polynomial")},
               {"moebius", FamilyChoice::kMoebius, family("moebius")},
               {"kubelka-munk", FamilyChoice::kLayer, family("kubelka-munk")}}),
          {en::say("'moebius' and 'kubelka-munk' need few presses where the layer is even; "
                   "'polynomial' follows any layer, given more of them"),
           en::say("'auto' fits all of them and leaves presses out for each"),
           {"moebius", "polynomial", "kubelka-munk", "auto"}}),
      number_setting<S>("degree",
                        en::say("degree of the polynomial; 0: chosen by leaving presses out"),
                        &S::degree, 0, 8),
      choice_setting<S, AlongChoice>(
          "along",
          en::say("the thickness of the layer that brightness follows: along z, along its normal, "
                  "or that along z projected onto the normal; auto: along the normal unless "
                  "presses left out show otherwise"),
          &S::along,
          {{"auto", AlongChoice::kAuto},
           {"z", AlongChoice::kZ},
           {"normal", AlongChoice::kNormal},
           {"projected", AlongChoice::kProjected}}),
      choice_setting<S, FaceVariationChoice>(
          "over-face",
          en::say("whether the mapping may vary slowly over the face, for uneven light or an "
                  "uneven layer; auto: if presses left out then agree clearly better"),
          &S::face_variation,
          {{"auto", FaceVariationChoice::kAuto}, {"even", FaceVariationChoice::kEven}}),
      with_trade_off(
          choice_setting<S, LightSpreadChoice>(
              "light-spread",
              en::say("whether the layer may give light back beside where it went in; auto: if the "
                      "brightness around the presses shows it, given three presses or more"),
              &S::light_spread,
              {{"auto", LightSpreadChoice::kAuto, en::say("light that may spread")},
               {"local", LightSpreadChoice::kLocal, en::say("local light")}}),
          {en::say("on a layer that scatters, 'auto' is more accurate, most of all with flat and "
                   "small bodies"),
           en::say("'auto' takes a few seconds more, and each image of a layer that spreads light "
                   "some hundredths of a second more"),
           {"local", "auto"}}),
      with_trade_off(
          number_setting<S>("iterations",
                            en::say("maximum number of rounds of the joint fit; it ends "
                                    "earlier when nothing changes"),
                            &S::iterations, 1, 60,
                            [](int n) { return en::count("{} iterations", "{} iteration", n); }),
          {en::say("more resolve contradictions between presses; too few leave the "
                   "curve where it began"),
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
