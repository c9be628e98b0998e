#include "calibration/verdict.h"

#include <cmath>

#include <fmt/format.h>

namespace alltact {

Verdict verdict(double residual_mm, double held_out_mm, int press_count) {
  const bool proven = press_count > 1 && held_out_mm > 0;
  Verdict result;
  result.error_mm = proven ? held_out_mm : residual_mm;
  const std::string measured =
      proven ? fmt::format("{:.3f} mm of depth error on presses it had not seen", result.error_mm)
             : fmt::format("{:.3f} mm of depth error on the very presses it was made from",
                           result.error_mm);
  if (!std::isfinite(result.error_mm) || result.error_mm > kUsableErrorMm) {
    result.grade = Grade::kUnfit;
    result.sentence = "not fit to measure with: " + measured +
                      "; press again with a clean ball of the radius given, whole on the face";
  } else if (!proven) {
    result.grade = Grade::kUnproven;
    result.sentence =
        "unproven: " + measured +
        (press_count > 1 ? "; none was left out to show what happens on others"
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
