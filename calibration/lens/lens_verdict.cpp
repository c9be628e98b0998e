#include "calibration/lens/lens_verdict.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

Grade grade_of_mm(double error_mm) {
  if (!(error_mm <= kUsableLensMm)) return Grade::kUnfit;
  return error_mm <= kGoodLensMm ? Grade::kGood : Grade::kUsable;
}

/// Held-out views that fit worse than fitted ones show that the model is wrong.
Grade grade_of_held_out(const LensEvidence& evidence) {
  const double ratio = evidence.held_out->error_px / std::max(evidence.sigma_px, 0.02);
  if (ratio > 3 && evidence.held_out->error_px > 1) return Grade::kUnfit;
  return ratio > 1.5 ? Grade::kUsable : Grade::kGood;
}

Message name_of(Grade grade) {
  switch (grade) {
    case Grade::kGood:
      return en::say("good");
    case Grade::kUsable:
      return en::say("usable");
    case Grade::kUnproven:
      return en::say("unproven");
    case Grade::kUnfit:
      break;
  }
  return en::say("not fit to measure with");
}

}  // namespace

Verdict lens_verdict(const LensEvidence& evidence) {
  Verdict result;
  result.error_mm = evidence.distance_mm * evidence.focal_sd_part;
  Grade grade = grade_of_mm(result.error_mm);
  Message reason = en::say("the focal length is known to {:.2g} %, {:.2g} mm at {:g} mm",
                           100 * evidence.focal_sd_part,
                           result.error_mm,
                           evidence.distance_mm);
  const auto lower_to = [&](Grade other, const Message& why) {
    if (other <= grade) return;
    grade = other;
    reason = en::clauses({reason, why});
  };
  if (evidence.halves) {
    // Each half has half the views: a lens of all views is about twice as precise.
    const double px = evidence.halves->median_px / 2;
    const double mm = px * evidence.distance_mm / evidence.focal_px;
    lower_to(grade_of_mm(mm),
             en::say("but two halves of the views disagree by {:.2f} px ({:.2g} mm)",
                     evidence.halves->median_px,
                     2 * mm));
  }
  if (evidence.held_out)
    lower_to(grade_of_held_out(evidence),
             en::say("but views left out fit worse ({:.2f} px) than those fitted ({:.2f} px)",
                     evidence.held_out->error_px,
                     evidence.sigma_px));
  if (!evidence.coverage.enough)
    lower_to(Grade::kUsable,
             en::say("but the views do not cover the picture and the tilts it needs"));
  if (!evidence.held_out)
    lower_to(Grade::kUnproven,
             en::say("with so few views none could be left out to show what it is worth"));
  result.grade = grade;
  const Message& more = evidence.coverage.advice;
  Message advice;
  if (!more.empty())
    advice = en::say("take {}", more);
  else if (grade != Grade::kGood)
    advice = en::say("add views, sharp and tilted, that fill the picture");
  result.sentence = en::clauses({en::at(name_of(grade), reason), advice});
  return result;
}

}  // namespace alltact
