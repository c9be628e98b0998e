// What a lens calibration is worth, in millimetres at the finger and in words.
#pragma once

#include "calibration/lens/lens_coverage.h"
#include "calibration/lens/lens_judge.h"
#include "calibration/verdict/verdict.h"

#include <optional>

namespace alltact {

struct LensEvidence {
  double focal_sd_part = 0;  ///< standard deviation of the focal length over it, the worse axis
  double distance_mm = 0;    ///< of the finger
  double focal_px = 0;
  double sigma_px = 0;  ///< of the fit
  std::optional<HeldOut> held_out;
  std::optional<LensDifference> halves;
  LensCoverage coverage;
};

/// Up to these the error of a distance measured at the finger lets a lens be good, or usable.
inline constexpr double kGoodLensMm = 0.1;
inline constexpr double kUsableLensMm = 0.3;

/// error_mm: the standard deviation of a distance at the finger that the lens alone causes. The
/// grade is the worst that any evidence gives; without views left out it is unproven.
[[nodiscard]] Verdict lens_verdict(const LensEvidence& evidence);

}  // namespace alltact
