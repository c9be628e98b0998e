#include "calibration/joint/verdict.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace alltact {

Verdict verdict(const VerdictEvidence& evidence) {
  const bool proven = evidence.presses > 1 && evidence.held_out_mm > 0;
  Verdict result;
  result.error_mm =
      proven ? std::max(std::hypot(evidence.held_out_mm, evidence.spread_mm), evidence.pixel_mm)
             : evidence.residual_mm;
  std::string measured =
      fmt::format("{:.3f} mm of depth error on the very presses it was made from", result.error_mm);
  if (proven)
    measured = fmt::format(
        "{:.3f} mm of depth error to be expected ({:.3f} mm in shape, on presses it had not seen; "
        "{:.3f} mm as a whole)",
        result.error_mm,
        evidence.held_out_mm,
        evidence.spread_mm);
  if (proven && evidence.pixel_mm > 0)
    measured = fmt::format(
        "{:.3f} mm of depth error to be expected ({:.3f} mm in shape, on presses it had not seen; "
        "{:.3f} mm as a whole; {:.3f} mm of a single pixel)",
        result.error_mm,
        evidence.held_out_mm,
        evidence.spread_mm,
        evidence.pixel_mm);
  if (!std::isfinite(result.error_mm) || result.error_mm > kUsableErrorMm) {
    result.grade = Grade::kUnfit;
    result.sentence = "not fit to measure with: " + measured +
                      "; press again with a clean ball of the radius given, whole on the face";
  } else if (!proven) {
    result.grade = Grade::kUnproven;
    result.sentence =
        "unproven: " + measured +
        (evidence.presses > 1 ? "; none was left out to show what happens on others"
                              : "; one press cannot show what happens on others, add presses of "
                                "different depth");
  } else if (result.error_mm > kGoodErrorMm) {
    result.grade = Grade::kUsable;
    result.sentence = "usable for contact and its place: " + measured +
                      "; add presses of different depth and place to measure relief";
  } else {
    result.grade = Grade::kGood;
    result.sentence = "good: " + measured;
  }
  return result;
}

}  // namespace alltact
