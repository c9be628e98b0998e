#include "calibration/joint/verdict.h"

#include <algorithm>
#include <cmath>

namespace alltact {

Verdict verdict(const VerdictEvidence& evidence) {
  const bool proven = evidence.presses > 1 && evidence.held_out_mm > 0;
  Verdict result;
  result.error_mm =
      proven ? std::max(std::hypot(evidence.held_out_mm, evidence.spread_mm), evidence.pixel_mm)
             : evidence.residual_mm;
  Message measured =
      en::say("{:.3f} mm of depth error on the very presses it was made from", result.error_mm);
  if (proven)
    measured = en::say(
        "{:.3f} mm of depth error to be expected ({:.3f} mm in shape, on presses it had not seen; "
        "{:.3f} mm as a whole)",
        result.error_mm,
        evidence.held_out_mm,
        evidence.spread_mm);
  if (proven && evidence.pixel_mm > 0)
    measured = en::say(
        "{:.3f} mm of depth error to be expected ({:.3f} mm in shape, on presses it had not seen; "
        "{:.3f} mm as a whole; {:.3f} mm of a single pixel)",
        result.error_mm,
        evidence.held_out_mm,
        evidence.spread_mm,
        evidence.pixel_mm);
  Message grade, advice;
  if (!std::isfinite(result.error_mm) || result.error_mm > kUsableErrorMm) {
    result.grade = Grade::kUnfit;
    grade = en::say("not fit to measure with");
    advice = en::say("press again with a clean ball of the radius given, whole on the face");
  } else if (!proven) {
    result.grade = Grade::kUnproven;
    grade = en::say("unproven");
    advice = evidence.presses > 1
                 ? en::say("none was left out to show what happens on others")
                 : en::say(
                       "one press cannot show what happens on others, add presses of "
                       "different depth");
  } else if (result.error_mm > kGoodErrorMm) {
    result.grade = Grade::kUsable;
    grade = en::say("usable for contact and its place");
    advice = en::say("add presses of different depth and place to measure relief");
  } else {
    result.grade = Grade::kGood;
    grade = en::say("good");
  }
  result.reason = en::clauses({measured, advice});
  result.sentence = en::at(grade, result.reason);
  return result;
}

}  // namespace alltact
